package org.dfra.river.bootstrap;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
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
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleIdentity;
import org.jspecify.annotations.Nullable;

/**
 * A robot whose registrar and modules all run in this virtual machine. It uses the same servers and
 * proxies as service groups, exported and found through lookup. It has no activation system, which
 * could restart ended modules, and no class server, because its callers have its classes. It is
 * created from the same XML as a robot in processes. Modules keep no state from one run to the
 * next. Robots that share a virtual machine share their administrators, and share an identity
 * unless each has one of its own.
 *
 * <p>{@link #start} starts the registrar and then the modules in the order written; {@link #close}
 * ends them in {@link org.dfra.core.robot.ShutdownOrder}.
 */
public final class EmbeddedRobot implements AutoCloseable {

  /** As the registrar of a robot in processes grants it. */
  private static final Duration LEASE = Duration.ofSeconds(30);

  private final RobotDescription robot;
  private final String host;
  private final @Nullable Path others;
  private final ServedModules modules;
  private final @Nullable ChannelIdentity identity; // null for that of the process

  @GuardedBy("this")
  private boolean started;

  @GuardedBy("this")
  private @Nullable Admission admission;

  /**
   * Creates a whole robot.
   *
   * @throws ConfigurationException if the robot has no registrar of its own, its host is not an
   *     address of this machine, or one of its additional hosts is unknown
   */
  public EmbeddedRobot(RobotDescription robot) {
    this(robot, null, null);
  }

  /**
   * Creates a whole robot that is a member of a team: what it exports is encrypted, and what it
   * calls knows it by this identity, as if it had a process of its own.
   *
   * @throws ConfigurationException as the other constructors
   */
  public EmbeddedRobot(RobotDescription robot, ChannelIdentity identity) {
    this(robot, null, identity);
  }

  /**
   * Creates a part of a robot whose other modules run under phoenix.
   *
   * @param phoenixState the folder of phoenix's state. The identities of these modules are stored
   *     there. Without them the other modules would treat these as modules of another robot with
   *     the same name. Null if there are no other modules.
   * @throws ConfigurationException if the robot has no registrar of its own, its host is not an
   *     address of this machine, or one of its additional hosts is unknown
   */
  public EmbeddedRobot(RobotDescription robot, @Nullable Path phoenixState) {
    this(robot, phoenixState, null);
  }

  private EmbeddedRobot(
      RobotDescription robot, @Nullable Path phoenixState, @Nullable ChannelIdentity identity) {
    this.identity = identity;
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
   * Starts the registrar and all modules. Does nothing the second time.
   *
   * @throws ConfigurationException if a module cannot be instantiated or exported, or a host of the
   *     robot's administrators is unknown; the modules that were started run until the robot is
   *     closed
   * @throws IOException if the registrar cannot be started, or an identity cannot be stored
   */
  public synchronized void start() throws IOException {
    if (started) {
      return;
    }
    started = true;
    boolean unused = identity == null ? serve() : CurrentIdentity.callAs(identity, this::serve);
  }

  private synchronized boolean serve() throws IOException {
    admission = AdministrationPolicy.admit(AddressRangeResolver.resolve(robot.administration()));
    LookupSettings places = LookupSettings.of(robot, host, registrar().start().port());
    for (ModuleDescription each : robot.modules()) {
      modules.serve(
          new ModuleActivation(each, identity(each), host, places.groups(), places.locators()));
    }
    return true;
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

  /** The description it was created from. */
  public RobotDescription description() {
    return robot;
  }

  /** Its own lookup service, which may be ended and started again while the modules run. */
  public EmbeddedRegistrar registrar() {
    return modules.registrar();
  }

  /**
   * {@inheritDoc} If one module cannot be closed, the others still are; then the exception is
   * thrown.
   */
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

  /**
   * The lookup services at which a robot's modules register.
   *
   * @param locators lookup services that they join by unicast, {@code jini://host:port} each
   * @param groups discovery groups whose lookup services they join by multicast; none if empty
   */
  record LookupSettings(List<String> locators, List<String> groups) {

    /**
     * The settings of a robot. Its own registrar is joined by unicast, so its modules need no
     * multicast for it. A robot on the loopback uses no multicast: other hosts could not reach the
     * announced address.
     *
     * @param host the robot's, resolved
     * @param port TCP port of its own registrar; 0 if that is unknown or there is no registrar
     */
    static LookupSettings of(RobotDescription robot, String host, int port) {
      List<String> locators = new ArrayList<>(robot.locators());
      String own = "jini://" + host + ":" + port;
      if (port != 0 && !locators.contains(own)) {
        locators.add(own);
      }
      return new LookupSettings(
          List.copyOf(locators), HostAddress.isLoopback(host) ? List.of() : robot.lookupGroups());
    }
  }
}
