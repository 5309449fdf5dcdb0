/**
 * The data flow from the world through a robot and back into the world.
 *
 * <pre>
 *   sensor ---&gt; perceptual schema ---&gt; motor schema ---&gt; effector
 * </pre>
 *
 * <p>Each stage has its own package: {@link org.dfra.flow.sensor}, {@link
 * org.dfra.flow.perceptual}, {@link org.dfra.flow.motor}, {@link org.dfra.flow.effector}. The two
 * ends are {@link org.dfra.flow.Device}s; the modules between them are {@link
 * org.dfra.flow.Schema}s. {@link org.dfra.flow.Chainable} wires one stage to the next; {@link
 * org.dfra.behavior} combines them to reach a goal.
 */
@NullMarked
package org.dfra.flow;

import org.jspecify.annotations.NullMarked;
