package org.dfra.core.module;

import java.time.InstantSource;
import org.dfra.core.config.Parameters;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.state.StateStore;
import org.dfra.time.Scheduler;

/**
 * What a driver is given when it is constructed.
 *
 * <p>Every driver named in a module's properties has a public constructor with this one argument.
 *
 * @param robot name of the robot, e.g. {@code atrv1}
 * @param name name of the module, e.g. {@code gps_front}
 * @param parameters what the robot's XML and the module's properties say of it
 * @param clock the time; simulated time where the robot is simulated
 * @param state what of the module outlives its virtual machine
 * @param leases what leases the module grants
 * @param scheduler the time of leases and deliveries, which is real even where the robot is not
 */
public record ModuleContext(
    String robot,
    String name,
    Parameters parameters,
    InstantSource clock,
    StateStore state,
    LeaseTerms leases,
    Scheduler scheduler) {

  /** Of a module that remembers nothing, under the usual terms. */
  public ModuleContext(String robot, String name, Parameters parameters, InstantSource clock) {
    this(robot, name, parameters, clock, StateStore.inMemory());
  }

  /** Of a module under the usual terms. */
  public ModuleContext(
      String robot, String name, Parameters parameters, InstantSource clock, StateStore state) {
    this(robot, name, parameters, clock, state, LeaseTerms.USUAL, Scheduler.system());
  }

  /** {@code robot/name}. */
  public String path() {
    return robot + "/" + name;
  }
}
