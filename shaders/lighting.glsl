// A soft three-light studio that stands relative to the camera, and light from all round. Reflection: GGX
// (Walter et al. 2007) with Hammon's visibility term (2017) and Schlick's Fresnel (1994); light from all round by
// Karis' fit (2014) of the same reflection's integral.
struct Reflector {
  vec3 diffuse;     // linear colour of the light that enters and comes out again
  vec3 specular;    // reflectance at normal incidence
  float roughness;  // 0 to 1, as materials state it
  float occlusion;  // 1: open to light from all round
};

struct Light {
  vec3 colour;
  float wrap;  // how far light reaches round the form: the softness of a large source
  float size;  // added to the surface's own roughness
};

const Light key_light = Light(vec3(1.00, 0.97, 0.93) * 1.04, 0.14, 0.06);
const Light fill_light = Light(vec3(0.86, 0.93, 1.00) * 0.20, 0.40, 0.18);
const Light rim_light = Light(vec3(0.95, 0.98, 1.00) * 0.60, 0.05, 0.08);
const vec3 sky = vec3(0.120, 0.130, 0.145);
const vec3 ground = vec3(0.060, 0.052, 0.046);
// What mirrors see: a bright ceiling over a darker room, brighter than its diffuse light for softness' sake.
const vec3 mirrored_sky = vec3(0.62, 0.65, 0.70);
const vec3 mirrored_ground = vec3(0.10, 0.09, 0.085);

vec3 light_from(Light light, vec3 l, vec3 n, vec3 to_eye, Reflector r) {
  const float nl = dot(n, l);
  const float diffuse = max((nl + light.wrap) / (1.0 + light.wrap), 0.0);
  vec3 sum = r.diffuse * (diffuse * diffuse * (1.5 - 0.5 * diffuse));
  const vec3 h = normalize(l + to_eye);
  const float nh = clamp(dot(n, h), 0.0, 1.0), nv = clamp(dot(n, to_eye), 1e-3, 1.0), vh = clamp(dot(to_eye, h), 0.0, 1.0);
  const float lit = clamp(nl, 0.0, 1.0);
  const float a = clamp(r.roughness * r.roughness + light.size, 0.0, 1.0), a2 = a * a;
  const float d = nh * nh * (a2 - 1.0) + 1.0;
  const float visibility = 0.5 / max(mix(2.0 * lit * nv, lit + nv, a), 1e-4);
  const float grazing = 1.0 - vh, grazing2 = grazing * grazing;
  const vec3 fresnel = r.specular + (1.0 - r.specular) * (grazing2 * grazing2 * grazing);
  sum += fresnel * (a2 / (d * d) * visibility * lit);
  return light.colour * sum;
}

vec3 light_from_all_round(vec3 n, vec3 to_eye, Reflector r) {
  const float nv = clamp(dot(n, to_eye), 0.0, 1.0);
  const vec3 mirrored = reflect(-to_eye, n);
  const float blur = 0.12 + 0.5 * r.roughness;
  const vec3 seen = mix(mirrored_ground, mirrored_sky, smoothstep(-blur, blur, mirrored.y) * (0.75 + 0.25 * mirrored.y));
  const vec4 fit = r.roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  const float bias = min(fit.x * fit.x, exp2(-9.28 * nv)) * fit.x + fit.y;
  const vec3 reflectance = r.specular * (-1.04 * bias + fit.z) + (1.04 * bias + fit.w);
  // A rough surface spreads what it mirrors over all directions: it shines no brighter than the room's mean light.
  const vec3 mirror = mix(seen, mix(ground, sky, 0.5 + 0.5 * n.y) * 2.0, r.roughness * (1.0 - 0.6 * r.specular.g));
  return r.occlusion * (r.diffuse * mix(ground, sky, 0.5 + 0.5 * n.y) + reflectance * mirror);
}
