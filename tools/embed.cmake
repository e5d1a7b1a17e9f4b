# Writes the text file INPUT as a C++ raw string named NAME into the header OUTPUT.
file(READ ${INPUT} text)
file(WRITE ${OUTPUT} "inline constexpr char ${NAME}[] = R\"embedded(${text})embedded\";\n")
