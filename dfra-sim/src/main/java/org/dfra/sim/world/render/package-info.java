/**
 * Pictures of the world as cameras see them: a pin-hole camera, the ground with its pattern, the
 * sky, and everything that stands or lies or moves, in visible light or in heat.
 *
 * <pre>
 *   Facets of solids and mines (once) --+
 *   Facets of robots (each picture) ----+--&gt; Canvas: projects, keeps the nearest --&gt; samples
 *   Meadow, Sky, where nothing stands --+
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.world.render.Renderer}. Nothing here knows time or chance but for
 * the pattern of the ground, which follows from a seed.
 */
@NullMarked
package org.dfra.sim.world.render;

import org.jspecify.annotations.NullMarked;
