package org.dfra.flow;

import org.dfra.geometry.Posable;
import org.dfra.module.Diagnosable;
import org.dfra.module.Module;

/**
 * A module that is hardware: mounted somewhere, at an end of a chain, and able to examine itself.
 * It is a {@link org.dfra.flow.sensor.Sensor} or an {@link org.dfra.flow.effector.Effector}.
 */
public interface Device extends Module, Posable, Diagnosable, Chainable {}
