/**
 * The flow from the world through a robot and back into the world.
 *
 * <pre>
 *   sensor ---&gt; perceptual schema ---&gt; motor schema ---&gt; effector
 * </pre>
 *
 * <p>Each stage has its own package; this release holds {@link org.dfra.flow.sensor}. What wires
 * one stage to the next is {@link org.dfra.flow.Chainable}.
 */
@NullMarked
package org.dfra.flow;

import org.jspecify.annotations.NullMarked;
