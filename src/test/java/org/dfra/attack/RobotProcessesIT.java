package org.dfra.attack;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.SocketTimeoutException;
import java.nio.file.Path;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.Activator;
import java.rmi.registry.LocateRegistry;
import java.rmi.server.RemoteObject;
import java.rmi.server.RemoteObjectInvocationHandler;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import net.jini.admin.Administrable;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.id.Uuid;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.ObjectEndpoint;
import net.jini.lookup.DiscoveryAdmin;
import org.dfra.attack.kit.AttackHosts;
import org.dfra.attack.kit.Victim;
import org.dfra.benchmarks.attack.CallBytes;
import org.dfra.benchmarks.attack.ProcessSample;
import org.dfra.benchmarks.attack.RawCall;
import org.dfra.benchmarks.attack.RawCall.Answer;
import org.dfra.benchmarks.attack.RawCall.Status;
import org.dfra.benchmarks.attack.SourceBoundProxies;
import org.dfra.benchmarks.attack.SourceSockets;
import org.dfra.drive.WheeledRobot;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.module.AdministrationRefusedException;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.ResurrectingHandler;
import org.dfra.river.phoenix.PhoenixIdentities;
import org.dfra.river.phoenix.stop.StopLocator;
import org.dfra.river.phoenix.stop.StopService;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.remote.effector.RemoteDriveEffector;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Attacks on a robot as a user brings it up: its phoenix, its registrar and its drive are processes
 * of their own, which get their filters and their administrators from the bootstrap.
 */
@Timeout(180)
class RobotProcessesIT {

  private static final Duration PATIENCE = Duration.ofSeconds(20);

  /** For what must not happen, in milliseconds. */
  private static final int BRIEF = 300;

  /** References for each object. Each would keep a thread; together more than may be. */
  private static final int REFERENCES = Victim.THREADS + 16;

  @TempDir static Path folder;

  private static AttackHosts hosts;
  private static WheeledRobot robot;

  @BeforeAll
  static void bringUp() throws Exception {
    hosts = AttackHosts.assumed();
    robot = WheeledRobot.startAdministeredFrom(hosts.operator(), folder, "drive");
  }

  @AfterAll
  static void takeDown() throws Exception {
    if (robot != null) { // else it has said why, and nothing is left of it
      robot.close();
    }
  }

  /**
   * What a stranger can call.
   *
   * @param pid the process that exports it
   * @param method one of its methods, which has an object as a parameter
   */
  private record Target(String name, long pid, ObjectEndpoint object, Method method) {}

  private static List<Target> targets() throws Exception {
    ServiceRegistrar registrar = registrar();
    String[] unused = registrar.getGroups(); // now its proxy has reached it
    Remote reggie = SourceBoundProxies.remote(registrar, Remote.class);
    long phoenix = robot.phoenix().process().pid().orElseThrow();
    return List.of(
        new Target(
            "the drive",
            robot.phoenix().group("eta.wheels").pid(),
            RawCall.endpoint(server()),
            RemoteModule.class.getMethod("subscribe", ModuleListener.class, DeliveryPolicy.class)),
        new Target(
            "the registrar",
            robot.phoenix().group("eta.lookup").pid(),
            RawCall.endpoint(reggie),
            method(reggie, "register")),
        new Target(
            "phoenix's activator",
            phoenix,
            ofPhoenix(PhoenixIdentities.ACTIVATOR),
            Activator.class.getMethod("activate", ActivationID.class, boolean.class)),
        new Target(
            "phoenix's stop service",
            phoenix,
            ofPhoenix(StopLocator.IDENTITY),
            StopService.class.getMethod("emergencyStop", List.class, String.class)));
  }

  private static ServiceRegistrar registrar() throws Exception {
    return new LookupLocator(robot.locator()).getRegistrar();
  }

  private static RemoteDriveEffector server() throws IOException {
    return SourceBoundProxies.remote(robot.drive(), RemoteDriveEffector.class);
  }

  private static ObjectEndpoint ofPhoenix(Uuid identity) {
    PhoenixProcess phoenix = robot.phoenix().process();
    return new BasicObjectEndpoint(
        Endpoints.tcpClient(phoenix.host(), phoenix.port()), identity, false);
  }

  private static Method method(Object proxy, String name) {
    return Arrays.stream(proxy.getClass().getInterfaces())
        .flatMap(type -> Arrays.stream(type.getMethods()))
        .filter(method -> method.getName().equals(name))
        .findAny()
        .orElseThrow();
  }

  @Test
  void noProcessConnectsToWhatAJrmpReferenceNames() throws Exception {
    try (ServerSocket attacker = new ServerSocket(0, 50, InetAddress.getByName(hosts.attacker()))) {
      for (Target target : targets()) {
        int before = ProcessSample.threads(target.pid());
        assertRefused(target, attacker.getLocalPort());
        for (int port = 1; port < REFERENCES; port++) { // nobody listens there
          assertRefused(target, port);
        }
        assertThat(ProcessSample.threads(target.pid()) - before)
            .as("threads that %s keeps for %d references", target.name(), REFERENCES)
            .isLessThan(Victim.THREADS);
      }
      attacker.setSoTimeout(BRIEF);
      assertThatThrownBy(attacker::accept).isInstanceOf(SocketTimeoutException.class);
    }
    assertThat(robot.drive().readiness().serves()).isTrue();
    assertThat(robot.drive().emergencyStopState().latched())
        .as("by a refused order to stop")
        .isFalse();
  }

  private static void assertRefused(Target target, int port) throws Exception {
    byte[] call = CallBytes.with(target.method(), out -> out.writeObject(reference(port)));
    try (RawCall raw = RawCall.to(target.object())) {
      Answer answer = raw.send(call).finish(PATIENCE);
      assertThat(answer.status())
          .as("%s: %s", target.name(), answer.failure())
          .isEqualTo(Status.THREW);
      assertThat((Throwable) answer.object())
          .as(target.name())
          .hasStackTraceContaining("refused to read class java.rmi.server.RemoteObject")
          .hasStackTraceContaining("exported by JRMP");
    }
  }

  /** A reference of plain RMI to an object at a port of the attacker's address. */
  private static RemoteObjectInvocationHandler reference(int port) throws RemoteException {
    Remote registry = LocateRegistry.getRegistry(hosts.attacker(), port);
    return new RemoteObjectInvocationHandler(((RemoteObject) registry).getRef());
  }

  @Test
  void onlyTheConfiguredAddressAdministersItBesidesItsOwnComputer() throws Exception {
    RemoteDriveEffector stranger = drive(hosts.attackerSockets());
    assertThatThrownBy(() -> stranger.setParameter("max_speed", "0.2"))
        .isInstanceOf(AdministrationRefusedException.class)
        .hasMessageContaining(" is refused to " + hosts.attacker() + ":");
    assertThat(maxSpeed()).isEqualTo(1);
    drive(hosts.operatorSockets()).setParameter("max_speed", "0.5");
    assertThat(maxSpeed()).isEqualTo(0.5);
    robot.drive().setParameter("max_speed", "1"); // from the robot's own address
    assertThat(maxSpeed()).isEqualTo(1);

    DiscoveryAdmin strangers = registrarAdmin(hosts.attackerSockets());
    String[] groups = strangers.getMemberGroups();
    assertThatThrownBy(() -> strangers.setMemberGroups(groups))
        .isInstanceOf(AdministrationRefusedException.class)
        .hasMessageContaining(" is refused to " + hosts.attacker() + ":");
    registrarAdmin(hosts.operatorSockets()).setMemberGroups(groups); // as it was
  }

  /** The drive as it is called from an address; a call that fails does not ask the activator. */
  private static RemoteDriveEffector drive(SourceSockets sockets) throws IOException {
    ResurrectingHandler handler = (ResurrectingHandler) Proxy.getInvocationHandler(server());
    return SourceBoundProxies.of(
        (RemoteDriveEffector) Objects.requireNonNull(handler.live()), sockets);
  }

  private static DiscoveryAdmin registrarAdmin(SourceSockets sockets) throws Exception {
    return (DiscoveryAdmin)
        SourceBoundProxies.of(((Administrable) registrar()).getAdmin(), sockets);
  }

  private static double maxSpeed() throws RemoteException {
    return robot.drive().parameters().stream()
        .filter(each -> each.name().equals("max_speed"))
        .mapToDouble(each -> Double.parseDouble(each.value()))
        .findFirst()
        .orElseThrow();
  }
}
