package org.dfra.flow;

import org.dfra.geometry.Posable;
import org.dfra.module.Diagnosable;
import org.dfra.module.Module;

/**
 * A module that is hardware: mounted on the robot, at an end of a chain, with self-diagnosis. It is
 * a {@link org.dfra.flow.sensor.Sensor} or an {@link org.dfra.flow.effector.Effector}.
 */
public interface Device extends Module, Posable, Diagnosable, Chainable {}
