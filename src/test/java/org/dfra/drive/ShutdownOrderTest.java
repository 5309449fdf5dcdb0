package org.dfra.drive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import net.jini.admin.Administrable;
import net.jini.core.entry.Entry;
import net.jini.core.lease.Lease;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.security.ProxyPreparer;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.effector.DriveImpl;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.persona.DriveAttributes;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.river.bootstrap.ServedModules;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.lookup.LookupJoin;
import org.dfra.river.lookup.SuppliedConfiguration;
import org.dfra.river.proxy.effector.DriveProxy;
import org.dfra.river.remote.ModuleAdmin;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.dfra.river.server.effector.DriveServer;
import org.dfra.testing.EmbeddedReggie;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * An effector halts before its module leaves the lookup services, and leaves all of them within a
 * second: also where six have registered it and have not answered since.
 */
@Timeout(120)
public class ShutdownOrderTest {

  private static final int REGISTRARS = 6;
  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final Duration TO_CLOSED = Duration.ofMillis(500);

  /** The requirement for all registrations together. */
  private static final Duration TO_END = Duration.ofSeconds(1);

  /** What happened, in order: {@code halted}, {@code closed}, {@code leaves}. */
  private static final List<String> STEPS = new CopyOnWriteArrayList<>();

  private static volatile long closedAt; // System.nanoTime
  private static Silence silence; // of the test that runs

  private final List<EmbeddedRegistrar> registrars = new ArrayList<>();
  private final UUID id = UUID.randomUUID();

  @TempDir Path folder;

  /** A drive that does what it is commanded at once. */
  public static final class RecordedDrive extends DriveImpl {

    public RecordedDrive(ModuleContext context) {
      super(
          context, "a recorded drive", "DFRA", "1", new DriveAttributes(1, 2, 1, 1), 0, List.of());
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {
      closedAt = System.nanoTime();
      STEPS.add("closed");
    }

    @Override
    protected void setVelocity(Velocity wanted) {}

    @Override
    protected void halt() {
      STEPS.add("halted");
    }

    @Override
    protected void brake(boolean set) {}
  }

  /** What a registrar is asked when a registration is cancelled; by JERI, so with a deadline. */
  public interface Registration extends Remote {
    void cancel() throws RemoteException;
  }

  /**
   * A port that accepts connections and never answers, and the preparer of a lease by which each
   * cancellation goes to that port.
   */
  private static final class Silence implements ProxyPreparer, AutoCloseable {

    private final ServerSocket socket = new ServerSocket(0, 50, InetAddress.getByName("127.0.0.1"));
    private final List<Socket> accepted = new CopyOnWriteArrayList<>();
    private final Registration registration =
        (Registration)
            DeadlineILFactory.proxy(
                new BasicObjectEndpoint(
                    Endpoints.tcpClient("127.0.0.1", socket.getLocalPort()),
                    UuidFactory.generate(),
                    false),
                DeadlineILFactory.DEFAULT_DEADLINE,
                Registration.class.getClassLoader(),
                Registration.class);

    Silence() throws IOException {
      Thread acceptor =
          new Thread(
              () -> {
                try {
                  while (true) {
                    accepted.add(socket.accept());
                  }
                } catch (IOException e) {
                  // closed
                }
              },
              "silence");
      acceptor.setDaemon(true);
      acceptor.start();
    }

    @Override
    public Object prepareProxy(Object lease) {
      return Proxy.newProxyInstance(
          Lease.class.getClassLoader(),
          new Class<?>[] {Lease.class},
          (proxy, method, args) -> {
            switch (method.getName()) {
              case "cancel":
                STEPS.add("leaves");
                registration.cancel();
                return null;
              case "canBatch":
                return false;
              case "equals":
                return proxy == args[0];
              case "hashCode":
                return System.identityHashCode(proxy);
              default:
                try {
                  return method.invoke(lease, args);
                } catch (InvocationTargetException e) {
                  throw e.getCause();
                }
            }
          });
    }

    @Override
    public void close() throws IOException {
      socket.close();
      for (Socket each : accepted) {
        each.close();
      }
    }
  }

  /** For the module's Jini configuration. */
  public static ProxyPreparer silence() {
    return silence;
  }

  @BeforeEach
  void startRegistrars() throws Exception {
    STEPS.clear();
    silence = new Silence();
    for (int i = 0; i < REGISTRARS; i++) {
      registrars.add(
          new EmbeddedRegistrar(
                  EmbeddedReggie.HOST,
                  0,
                  List.of("shutdown-" + UUID.randomUUID()),
                  Duration.ofSeconds(30),
                  Map.of())
              .start());
    }
  }

  @AfterEach
  void endRegistrars() throws Exception {
    silence.close();
    for (EmbeddedRegistrar each : registrars) {
      each.close();
    }
  }

  private List<String> locators() {
    return registrars.stream().map(EmbeddedRegistrar::locator).toList();
  }

  private ModuleActivation activation() throws IOException {
    Path configuration =
        Files.writeString(
            folder.resolve("drive.config"),
            """
            net.jini.lookup.JoinManager {
                serviceLeasePreparer = org.dfra.drive.ShutdownOrderTest.silence();
            }
            """);
    return new ModuleActivation(
        new ModuleDescription(
            "robot",
            "drive",
            DriveServer.class.getName(),
            DriveProxy.class.getName(),
            RecordedDrive.class.getName(),
            configuration.toString(),
            false,
            Parameters.of("robot/drive", Map.of("command_timeout", "0.5")),
            SourceLocation.CODE),
        id,
        EmbeddedReggie.HOST,
        List.of(),
        locators());
  }

  private void awaitRegistrations() {
    ServiceID sought = new ServiceID(id.getMostSignificantBits(), id.getLeastSignificantBits());
    ServiceTemplate template = new ServiceTemplate(sought, null, null);
    for (EmbeddedRegistrar each : registrars) {
      await().atMost(PATIENCE).until(() -> each.registrar().lookup(template, 1).totalMatches == 1);
    }
  }

  /** A way by which a served module ends. */
  private interface Way {
    void end(DriveServer server) throws Exception;
  }

  private record Named(String name, Way way) {
    @Override
    public String toString() {
      return name;
    }
  }

  static Stream<Named> ways() {
    return Stream.of(
        new Named("closed", DriveServer::close),
        new Named("deactivated", server -> admin(server).deactivate()),
        new Named("destroyed", server -> admin(server).destroy()));
  }

  private static ModuleAdmin admin(DriveServer server) throws RemoteException {
    return (ModuleAdmin) ((Administrable) server.getProxy()).getAdmin();
  }

  @ParameterizedTest
  @MethodSource("ways")
  void aDriveHaltsFirstAndLeavesSixSilentRegistrarsWithinASecond(Named way) throws Exception {
    try (DriveServer server =
        ModuleServer.started(new DriveServer(null, new MarshalledObject<>(activation())))) {
      DriveEffector drive = (DriveEffector) server.getProxy();
      CommandLease lease = drive.acquireCommandLease(Duration.ofSeconds(10));
      drive.execute(lease.key(), new Velocity(0.5, 0));
      awaitRegistrations();
      STEPS.clear();
      assertEndsInTime(() -> way.way().end(server));
      assertThatThrownBy(() -> drive.execute(lease.key(), new Velocity(0.5, 0)))
          .as("a command after the end")
          .isInstanceOfAny(RemoteException.class, NotReadyException.class);
    }
  }

  @Test
  void anEmbeddedRobotHaltsFirst() throws Exception {
    EmbeddedRegistrar own =
        new EmbeddedRegistrar(
                EmbeddedReggie.HOST, 0, List.of("own-" + id), Duration.ofSeconds(30), Map.of())
            .start();
    try (ServedModules robot = new ServedModules("robot", own)) {
      robot.serve(activation());
      awaitRegistrations();
      STEPS.clear();
      assertEndsInTime(robot::close);
    }
  }

  private interface Ended {
    void end() throws Exception;
  }

  /** In order for certain, and in time where the computer had any for this test. */
  private static void assertEndsInTime(Ended body) throws Exception {
    Timing toClosed;
    Timing toEnd;
    try (StallProbe probe = StallProbe.start()) {
      StallProbe.Stopwatch begun = probe.stopwatch();
      long began = System.nanoTime();
      body.end();
      toEnd = begun.stop();
      toClosed = toEnd.ofPart(Duration.ofNanos(closedAt - began));
    }
    System.out.printf("driver closed: %s; all ended: %s%n", toClosed, toEnd);
    assertThat(STEPS.indexOf("closed")).as("steps " + STEPS).isNotNegative();
    assertThat(STEPS.subList(0, STEPS.indexOf("closed"))).doesNotContain("leaves");
    await("the others are asked beside each other")
        .atMost(PATIENCE)
        .untilAsserted(
            () ->
                assertThat(STEPS.stream().filter("leaves"::equals).count())
                    .as("steps " + STEPS)
                    .isEqualTo(REGISTRARS));
    toClosed.requireWithin("closing the driver", TO_CLOSED);
    toEnd.requireWithin("ending a module that six silent registrars hold", TO_END);
  }

  @Test
  void registrationsAreCancelledBesideEachOther() throws Exception {
    try (LookupJoin join =
        LookupJoin.start(
            "a service",
            id,
            new Entry[0],
            List.of(),
            locators(),
            new SuppliedConfiguration(
                Map.of("net.jini.lookup.JoinManager.serviceLeasePreparer", () -> silence)))) {
      awaitRegistrations();
      try (StallProbe probe = StallProbe.start()) {
        StallProbe.Stopwatch begun = probe.stopwatch();
        join.close();
        begun.stop().requireWithin("leaving six silent registrars", TO_END);
      }
    }
  }
}
