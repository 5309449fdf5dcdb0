/**
 * Renders camera images of the world: a pinhole camera, the ground with its pattern, the sky,
 * obstacles, mines and robots, in visible light or thermal infrared.
 *
 * <pre>
 *   Facets of obstacles and mines (once) --+
 *   Facets of robots (each image) ---------+--&gt; Rasterizer: projects, depth test --&gt; samples
 *   GroundTexture, Light: background ------+
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.world.render.Renderer}. Nothing here depends on time or random
 * numbers, except the pattern of the ground, which depends on a seed.
 */
@NullMarked
package org.dfra.sim.world.render;

import org.jspecify.annotations.NullMarked;
