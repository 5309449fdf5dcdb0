package org.dfra.flow;

import org.dfra.module.Module;

/**
 * A module that is software: it stands between sensors and effectors and knows no hardware. It is a
 * {@link org.dfra.flow.perceptual.PerceptualSchema}, a {@link org.dfra.flow.motor.MotorSchema}, or
 * a {@link org.dfra.behavior.Behavior} made of both.
 *
 * <p>Where its inputs are not wired, it takes them from the modules of its own robot that can give
 * them.
 */
public interface Schema extends Module, Chainable {}
