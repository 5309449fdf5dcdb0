/**
 * The flow from the world through a robot and back into the world.
 *
 * <pre>
 *   sensor ---&gt; perceptual schema ---&gt; motor schema ---&gt; effector
 * </pre>
 *
 * <p>Each stage has its own package: {@link org.dfra.flow.sensor}, {@link
 * org.dfra.flow.perceptual}, {@link org.dfra.flow.motor}, {@link org.dfra.flow.effector}. The two
 * ends are {@link org.dfra.flow.Device}s, what is between them is a {@link org.dfra.flow.Schema}.
 * What wires one stage to the next is {@link org.dfra.flow.Chainable}; what joins them to reach a
 * goal is {@link org.dfra.behavior}.
 */
@NullMarked
package org.dfra.flow;

import org.jspecify.annotations.NullMarked;
