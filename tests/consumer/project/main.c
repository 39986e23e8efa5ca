/* SPDX-License-Identifier: GPL-3.0-or-later
 * A user's program, ten lines: the ball model and the closed surface of six points. */
#include <stdio.h>
#include <vbm/vbm.h>

int main(void) {
  const double points[] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  vbm_context *context = NULL;
  vbm_model *model = NULL;
  vbm_surface *surface = NULL;
  vbm_surface_report report = {.struct_size = sizeof report};
  if (vbm_context_create(&context) || vbm_build_points(context, points, 6, NULL, NULL, &model) ||
      vbm_model_surface(context, model, &surface) || vbm_surface_get_report(surface, &report))
    return fprintf(stderr, "%s\n", vbm_context_message(context)), 1;
  printf("%d triangles, volume %.3f\n", (int)report.triangles, report.volume);
  return vbm_surface_free(surface), vbm_model_free(model), vbm_context_free(context), 0;
}
