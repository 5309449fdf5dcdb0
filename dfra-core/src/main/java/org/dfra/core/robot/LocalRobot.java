package org.dfra.core.robot;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.ModuleClassFactory;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.state.StateStore;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.module.Module;
import org.dfra.time.Scheduler;

/**
 * A robot whose modules all run in this virtual machine and find each other in its memory: no
 * lookup service, no activation, no proxies. It is built from the same XML as one on the network,
 * of which only the drivers are used. Several robots with one directory form a team.
 *
 * <p>{@link #start} starts the modules in file order; {@link #close} closes them in {@link
 * ShutdownOrder}.
 */
public final class LocalRobot implements AutoCloseable {

  private final String name;
  private final InMemoryModuleDirectory directory;
  private final List<ModuleImpl> modules = new ArrayList<>();

  @GuardedBy("this")
  private final List<DirectoryRegistration> listed = new ArrayList<>();

  @GuardedBy("this")
  private boolean started;

  /**
   * Creates its modules.
   *
   * @param directory the directory of the team
   * @param clock the clock; a simulated clock if the robot is simulated
   * @param states the persistent state of a module, by its path
   * @throws org.dfra.core.config.ConfigurationException if a module cannot be created; those before
   *     it are closed
   */
  public LocalRobot(
      RobotDescription description,
      InMemoryModuleDirectory directory,
      InstantSource clock,
      Function<String, StateStore> states) {
    this.name = description.name();
    this.directory = directory;
    Scheduler scheduler =
        clock instanceof Scheduler own && own.isLockStep() ? own : Scheduler.system();
    try {
      for (ModuleDescription each : description.modules()) {
        ModuleContext context =
            new ModuleContext(
                each.robot(),
                each.name(),
                each.parameters(),
                clock,
                states.apply(each.path()),
                LeaseTerms.DEFAULT,
                scheduler,
                () -> directory);
        modules.add(
            new ModuleClassFactory(each).createDriver(context, Module.class, ModuleImpl.class));
      }
    } catch (RuntimeException e) {
      endAll().addSuppressedTo(e);
      throw e;
    }
  }

  /**
   * Starts the modules and lists them. Does nothing if already started.
   *
   * @throws RuntimeException if one cannot be started; those before it are running
   */
  public synchronized void start() {
    if (started) {
      return;
    }
    started = true;
    for (ModuleImpl module : modules) {
      module.start();
      listed.add(directory.add(module));
    }
  }

  /** Name of the robot. */
  public String name() {
    return name;
  }

  /** Its modules, in file order. */
  public List<ModuleImpl> modules() {
    return List.copyOf(modules);
  }

  /**
   * One of its modules.
   *
   * @return empty if there is none of that name and kind
   */
  public <M> Optional<M> module(String module, Class<M> kind) {
    return modules.stream()
        .filter(each -> each.identification().name().equals(module))
        .filter(kind::isInstance)
        .map(kind::cast)
        .findFirst();
  }

  /**
   * Closes the modules, effectors first; see {@link ShutdownOrder}.
   *
   * @throws IllegalStateException if one could not be closed; the others were
   */
  @Override
  public synchronized void close() {
    ResourceCloser ending = endAll();
    listed.forEach(each -> ending.close(each::close));
    listed.clear();
    ending.throwIfFailed(IllegalStateException::new);
  }

  private ResourceCloser endAll() {
    ResourceCloser ending = new ResourceCloser("robot " + name);
    ShutdownOrder.of(modules).forEach(ending::close);
    return ending;
  }
}
