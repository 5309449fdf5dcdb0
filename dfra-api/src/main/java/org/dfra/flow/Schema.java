package org.dfra.flow;

import org.dfra.module.Module;

/**
 * A module that is software: it operates between sensors and effectors and is independent of
 * hardware. It is a {@link org.dfra.flow.perceptual.PerceptualSchema}, a {@link
 * org.dfra.flow.motor.MotorSchema}, or a {@link org.dfra.behavior.Behavior} that combines both.
 *
 * <p>If its inputs are not wired, it subscribes to the suitable modules of its own robot.
 */
public interface Schema extends Module, Chainable {}
