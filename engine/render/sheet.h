#pragma once
/// Several pictures as one: contact sheets, panels side by side, and insets.

#include <span>
#include <string>
#include <vector>

#include "engine/render/text.h"

namespace sinew {

/// A labelled picture of a sheet; the picture must outlive the call.
struct Panel {
  const Picture* picture = nullptr;
  std::string label{};  ///< may be empty
};

enum class LabelPlace { under, inside };  ///< both at the panel's lower left

struct SheetOptions {
  int columns = 0;  ///< 0: as many as there are panels, in one row
  int rows = 0;     ///< 0: as many as are needed
  int gutter = 8;   ///< pixels between panels and round the sheet
  LabelPlace labels = LabelPlace::inside;
  double text_size = 0.0;  ///< pixels; 0: by the panels' height
  Colour background{255, 255, 255};
};

/// Lays out pictures of one size row by row. Their pixels are copied as they are, alpha too, but for labels inside.
/// With labels under the panels every row has room for them, if there is any label at all; places without a panel show
/// the background. `font` may be null where no panel has a label. Fails as bad_input where there is no panel, where
/// sizes differ, where there are more panels than places, or where the sheet would be larger than a PNG may be.
Result<Picture> sheet(std::span<const Panel> panels, const SheetOptions& options, const Font* font);

enum class Corner { upper_right, lower_right };

struct InsetOptions {
  Corner corner = Corner::upper_right;
  int margin = 0;  ///< pixels to the picture's edges; 0: by its height
  std::string label{};
  Colour border{26, 34, 43};
};

/// Puts a picture over a corner of another one, its pixels as they are, with a thin border round it and its label
/// inside at the lower left. `font` may be null where there is no label. Fails as bad_input where it does not fit.
Result<void> add_inset(Picture& picture, const Picture& inset, const InsetOptions& options, const Font* font);

}  // namespace sinew
