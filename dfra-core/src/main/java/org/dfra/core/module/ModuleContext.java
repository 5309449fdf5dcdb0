package org.dfra.core.module;

import java.time.InstantSource;
import org.dfra.core.config.Parameters;

/**
 * What a driver is given when it is constructed.
 *
 * <p>Every driver named in a module's properties has a public constructor with this one argument.
 *
 * @param robot name of the robot, e.g. {@code atrv1}
 * @param name name of the module, e.g. {@code gps_front}
 * @param parameters what the robot's XML and the module's properties say of it
 * @param clock the time; simulated time where the robot is simulated
 */
public record ModuleContext(
    String robot, String name, Parameters parameters, InstantSource clock) {}
