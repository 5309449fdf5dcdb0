package org.dfra.core.module;

import java.time.InstantSource;
import java.util.function.Supplier;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.Parameters;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.state.StateStore;
import org.dfra.directory.ModuleDirectory;
import org.dfra.time.Scheduler;

/**
 * The environment of a driver, passed to its constructor.
 *
 * <p>Every driver named in a module's properties has a public constructor with this one argument.
 *
 * @param robot name of the robot, e.g. {@code atrv1}
 * @param name name of the module, e.g. {@code gps_front}
 * @param parameters its parameters in the robot's XML and the module's properties
 * @param clock the clock; a simulated clock if the robot is simulated
 * @param state the module's persistent state
 * @param leases the terms of the module's leases
 * @param scheduler the scheduler of leases and deliveries; it runs in real time even for a
 *     simulated robot, unless it is simulated in lock-step
 * @param directorySource provides the directory; called only if the module needs others
 */
public record ModuleContext(
    String robot,
    String name,
    Parameters parameters,
    InstantSource clock,
    StateStore state,
    LeaseTerms leases,
    Scheduler scheduler,
    Supplier<ModuleDirectory> directorySource) {

  /** The context of a module that needs no others. */
  public ModuleContext(
      String robot,
      String name,
      Parameters parameters,
      InstantSource clock,
      StateStore state,
      LeaseTerms leases,
      Scheduler scheduler) {
    this(robot, name, parameters, clock, state, leases, scheduler, () -> nobody(robot, name));
  }

  /** The context of a module without persistent state, with the default lease terms. */
  public ModuleContext(String robot, String name, Parameters parameters, InstantSource clock) {
    this(robot, name, parameters, clock, StateStore.inMemory());
  }

  /** The context of a module with the default lease terms. */
  public ModuleContext(
      String robot, String name, Parameters parameters, InstantSource clock, StateStore state) {
    this(robot, name, parameters, clock, state, LeaseTerms.DEFAULT, schedulerOf(clock));
  }

  /** A copy with another directory. */
  public ModuleContext withDirectory(ModuleDirectory others) {
    return new ModuleContext(
        robot, name, parameters, clock, state, leases, scheduler, () -> others);
  }

  /** A copy with other lease terms. */
  public ModuleContext with(LeaseTerms others) {
    return new ModuleContext(
        robot, name, parameters, clock, state, others, scheduler, directorySource);
  }

  /** A copy with other parameters. */
  ModuleContext with(Parameters others) {
    return new ModuleContext(robot, name, others, clock, state, leases, scheduler, directorySource);
  }

  /**
   * The directory of modules, those of its own robot and those of others.
   *
   * @throws ConfigurationException if it has none
   */
  public ModuleDirectory directory() {
    return directorySource.get();
  }

  private static ModuleDirectory nobody(String robot, String name) {
    throw new ConfigurationException(
        robot
            + "/"
            + name
            + " needs other modules and was made without a directory; give its context one by"
            + " ModuleContext.withDirectory");
  }

  /** In lock-step the clock is also the scheduler. */
  private static Scheduler schedulerOf(InstantSource clock) {
    return clock instanceof Scheduler scheduler ? scheduler : Scheduler.system();
  }

  /**
   * The scheduler of the robot's own time, for delayed actions on its devices: the simulation's if
   * its clock is simulated.
   */
  public Scheduler robotTime() {
    return clock instanceof Scheduler simulated ? simulated : scheduler;
  }

  /** {@code robot/name}. */
  public String path() {
    return robot + "/" + name;
  }
}
