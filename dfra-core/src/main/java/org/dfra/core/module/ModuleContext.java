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
 * @param scheduler the time of leases and deliveries; it is real even where the robot is not,
 *     unless the robot is simulated in lock-step
 * @param directorySource gives what other modules are found by; asked for only where a module needs
 *     others
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

  /** Of a module that needs no others. */
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

  /** Of a module that remembers nothing, under the usual terms. */
  public ModuleContext(String robot, String name, Parameters parameters, InstantSource clock) {
    this(robot, name, parameters, clock, StateStore.inMemory());
  }

  /** Of a module under the usual terms. */
  public ModuleContext(
      String robot, String name, Parameters parameters, InstantSource clock, StateStore state) {
    this(robot, name, parameters, clock, state, LeaseTerms.DEFAULT, schedulerOf(clock));
  }

  /** The same module among others. */
  public ModuleContext withDirectory(ModuleDirectory others) {
    return new ModuleContext(
        robot, name, parameters, clock, state, leases, scheduler, () -> others);
  }

  /** The same module with other leases on it. */
  public ModuleContext with(LeaseTerms others) {
    return new ModuleContext(
        robot, name, parameters, clock, state, others, scheduler, directorySource);
  }

  /** The same module told other parameters. */
  ModuleContext with(Parameters others) {
    return new ModuleContext(robot, name, others, clock, state, leases, scheduler, directorySource);
  }

  /**
   * What other modules are found by, those of its own robot and those of others.
   *
   * @throws ConfigurationException if it was made without
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

  /** Where clock and scheduler are one, as in lock-step, nobody can take the wrong one. */
  private static Scheduler schedulerOf(InstantSource clock) {
    return clock instanceof Scheduler scheduler ? scheduler : Scheduler.system();
  }

  /**
   * The time of the robot itself, for what must happen later to its devices: that of its clock,
   * where the clock is that of a simulation.
   */
  public Scheduler robotTime() {
    return clock instanceof Scheduler simulated ? simulated : scheduler;
  }

  /** {@code robot/name}. */
  public String path() {
    return robot + "/" + name;
  }
}
