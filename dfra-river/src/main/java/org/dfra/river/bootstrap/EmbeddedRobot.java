package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.UUID;
import net.jini.core.entry.Entry;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.river.access.AdministrationPolicy;
import org.dfra.river.access.AdministrationPolicy.Admission;
import org.dfra.river.entry.Entries;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleIdentity;
import org.jspecify.annotations.Nullable;

/**
 * A robot whose registrar and modules all live in this virtual machine: the same servers and
 * proxies as in service groups, exported and found through lookup, but no activation system, which
 * could bring back what ends, and no class server, since whoever calls them here has their classes.
 * It is made of the same XML as one in processes. Modules remember nothing from one life to the
 * next. Robots that share a virtual machine share their administrators.
 *
 * <p>{@link #start} starts the registrar and then the modules in the order written; {@link #close}
 * ends them in {@link org.dfra.core.robot.ShutdownOrder}.
 */
public final class EmbeddedRobot implements AutoCloseable {

  /** As a robot's registrar in a process grants it. */
  private static final Duration LEASE = Duration.ofSeconds(30);

  private final RobotDescription robot;
  private final String host;
  private final @Nullable Path others;
  private final ServedModules modules;
  private boolean started; // guarded by this
  private @Nullable Admission admission; // guarded by this

  /**
   * A whole robot.
   *
   * @throws ConfigurationException if the robot has no registrar of its own, its host is none of
   *     this machine, or a further computer of it is not known
   */
  public EmbeddedRobot(RobotDescription robot) {
    this(robot, null);
  }

  /**
   * A part of a robot whose other modules phoenix has.
   *
   * @param phoenixState the folder of phoenix's state. The identities of these modules are kept
   *     there, without which the others would take them for those of another robot of that name.
   *     Null where there are no others.
   * @throws ConfigurationException if the robot has no registrar of its own, its host is none of
   *     this machine, or a further computer of it is not known
   */
  public EmbeddedRobot(RobotDescription robot, @Nullable Path phoenixState) {
    this.robot = robot;
    this.others = phoenixState;
    this.host = HostAddress.resolve(robot.host());
    RegistrarDescription described =
        robot
            .registrar()
            .orElseThrow(
                () ->
                    new ConfigurationException(
                        robot.source()
                            + ": robot "
                            + robot.name()
                            + " has no registrar, without which its modules do not find each other;"
                            + " add one to a group"));
    List<Entry> persona =
        List.of(robot.persona().map(each -> Entries.toEntries(List.of(each))).orElse(new Entry[0]));
    this.modules =
        new ServedModules(
            "robot " + robot.name(),
            new EmbeddedRegistrar(
                host,
                described.port(),
                robot.lookupGroups(),
                LEASE,
                RobotRegistrar.policy(robot, described),
                EmbeddedRegistrar.withLookupAttributes(persona)));
  }

  /**
   * Starts all of it. Does nothing the second time.
   *
   * @throws ConfigurationException if a module cannot be made or served, or a host of the robot's
   *     administrators is not known; what was started before it runs until it is closed
   * @throws IOException if the registrar cannot be started, or an identity cannot be kept
   */
  public synchronized void start() throws IOException {
    if (started) {
      return;
    }
    started = true;
    admission = AdministrationPolicy.admit(AddressRangeResolver.resolve(robot.administration()));
    LookupSettings places = LookupSettings.of(robot, host, registrar().start().port());
    for (ModuleDescription each : robot.modules()) {
      modules.serve(
          new ModuleActivation(each, identity(each), host, places.groups(), places.locators()));
    }
  }

  private UUID identity(ModuleDescription module) throws IOException {
    ModuleIdentity identity = ModuleIdentity.fresh();
    if (others != null) {
      identity.store(RobotBootstrap.moduleStateFolder(others, robot.name(), module.name()));
    }
    return identity.id();
  }

  /** Name of the robot. */
  public String name() {
    return robot.name();
  }

  /** What it was made from. */
  public RobotDescription description() {
    return robot;
  }

  /** Its own lookup service, which may be ended and started again while the modules run. */
  public EmbeddedRegistrar registrar() {
    return modules.registrar();
  }

  /** {@inheritDoc} Where one module cannot be closed, the others are, and then that is thrown. */
  @Override
  public synchronized void close() throws IOException {
    try {
      modules.close();
    } finally {
      if (admission != null) {
        admission.close();
        admission = null;
      }
    }
  }
}
