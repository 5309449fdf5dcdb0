package org.dfra.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.awaitility.core.ConditionFactory;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.FreePorts;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.geometry.GeoPosition;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Incident;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.ModuleHistory;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.sim.device.gps.M12Emulator;
import org.dfra.sim.device.gps.M12EmulatorSettings;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * A client listens to a receiver whose group, a process of its own, is killed and stopped.
 *
 * <p>Short: the tests share the robot. {@code dfra.full}: each has its own.
 */
@Timeout(120)
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class SubscriptionIT {

  private static final boolean FULL = Boolean.getBoolean("dfra.full");
  private static final String HOST = "127.0.0.1";
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  /** The requirement for a subscription and a lease after a crash. */
  private static final Duration BACK = Duration.ofSeconds(5);

  /** The requirement for a silent peer. */
  private static final Duration REPORTED = Duration.ofSeconds(3);

  @TempDir static Path folder;

  private static RunningPhoenix phoenix;
  private static M12Emulator receiver;
  private static JiniModuleDirectory directory;
  private static GPSSensor gps;
  private static boolean isUp;

  private final StallProbe probe = StallProbe.start();
  private final List<Delivery> received = new CopyOnWriteArrayList<>();

  @BeforeEach
  void bringUp() throws Exception {
    if (isUp) {
      return;
    }
    Path own = Files.createTempDirectory(folder, "robot");
    receiver =
        new M12Emulator(
            M12EmulatorSettings.at(new GeoPosition(52.9, 6.9, 50)).withBaud(115_200), Instant::now);
    receiver.start();
    phoenix = RunningPhoenix.start(own.resolve("phoenix"));
    int port = FreePorts.allocate();
    Path xml = own.resolve("robot.xml");
    Files.writeString(
        xml,
        """
        <robot xmlns="urn:dfra:robot:1" name="zeta" host="127.0.0.1">
          <group name="lookup"><registrar port="%d"/></group>
          <group name="gps">
            <module name="gps_front" server="org.dfra.river.server.sensor.GPSServer"
                proxy="org.dfra.river.proxy.sensor.GPSProxy"
                implementation="org.dfra.drivers.gps.m12.M12PlusImpl">
              <parameter name="link" value="%s"/>
            </module>
          </group>
        </robot>
        """
            .formatted(port, receiver.url()));
    List<RobotBootstrap.ServiceReference> unused =
        new RobotBootstrap(phoenix.process(), RobotXml.read(xml)).up();
    phoenix.note();
    directory = new JiniModuleDirectory(HOST, List.of(), List.of("jini://" + HOST + ":" + port));
    gps = directory.findFirst(ModuleQuery.of(GPSSensor.class), PATIENCE).orElseThrow().module();
    assertThat(gps.awaitReadiness(PATIENCE)).isEqualTo(Readiness.READY);
    isUp = true;
  }

  @AfterEach
  void takeDown() throws Exception {
    probe.close();
    if (FULL) {
      end();
    }
  }

  @AfterAll
  static void end() throws Exception {
    if (isUp) {
      isUp = false;
      directory.close();
      phoenix.close();
      receiver.close();
    }
  }

  @Test
  @Order(1) // it counts the activations
  void fixesComeAgainAfterKillMinusNineWithoutAnyClientCode() throws Exception {
    try (Subscription subscription = gps.subscribe(received::add, DeliveryPolicy.keepLast(10));
        ModuleLease lease = gps.acquireLease(Duration.ofSeconds(30))) {
      await().atMost(PATIENCE).until(() -> fixes(0) >= 2);
      Delivery last = received.get(received.size() - 1);

      StallProbe.Stopwatch killed = probe.stopwatch();
      phoenix.kill("zeta.gps");
      await()
          .atMost(PATIENCE)
          .pollInterval(Duration.ofMillis(20))
          .until(() -> received.get(received.size() - 1).epoch() > last.epoch());
      Timing back = killed.stop();
      phoenix.note();
      await().atMost(PATIENCE).until(() -> fixes(last.epoch() + 1) >= 2);

      System.out.printf(
          "listening again %.1f s after kill -9; %d events received, %d lost%n",
          back.took().toMillis() / 1e3, subscription.received(), subscription.lost());
      assertThat(subscription.lost())
          .as("events that no listener received at its start")
          .isPositive();
      patiently().until(lease::isLive);
      patiently().until(() -> gps.readiness() == Readiness.ACTIVE);
      Timing held = killed.stop();
      ModuleHistory history = gps.history();
      assertThat(history.activations()).isEqualTo(2);
      assertThat(history.recent())
          .extracting(Incident::kind)
          .containsSubsequence(
              Incident.Kind.ACTIVATION, Incident.Kind.FAILURE, Incident.Kind.ACTIVATION);
      back.requireWithin("listening again after kill -9", BACK);
      held.requireWithin("the lease counting again after kill -9", BACK);
    }
    patiently().until(() -> gps.readiness() == Readiness.READY);
    assertThat(gps.updateRate()).as("nobody needs it any more").isEqualTo(0.1);
  }

  @Test
  @Order(2)
  void aStoppedServerIsNoticedAndGoesOnWhenItCan() throws Exception {
    try (Subscription subscription = gps.subscribe(received::add, DeliveryPolicy.keepLast(10))) {
      await().atMost(PATIENCE).until(() -> fixes(0) >= 1);
      long pid = phoenix.group("zeta.gps").pid();
      StallProbe.Stopwatch stopped = probe.stopwatch();
      Timing noticed;
      StallProbe.Stopwatch resumed;
      signal("STOP", pid);
      try {
        await()
            .atMost(PATIENCE)
            .pollInterval(Duration.ofMillis(20))
            .until(() -> subscription.interruptedSince().isPresent());
        noticed = stopped.stop();
        System.out.printf(
            "a stopped server was noticed after %.1f s%n", noticed.took().toMillis() / 1e3);
      } finally {
        resumed = probe.stopwatch();
        signal("CONT", pid);
      }
      int before = fixes(0);
      await().atMost(PATIENCE).until(() -> subscription.interruptedSince().isEmpty());
      await().atMost(PATIENCE).until(() -> fixes(0) > before);
      Timing back = resumed.stop();
      noticed.requireWithin("a silent server being reported", REPORTED);
      back.requireWithin("listening again to a server that was suspended", BACK);
    }
  }

  /** A call that a busy machine did not answer in time is made again. */
  private static ConditionFactory patiently() {
    return await().atMost(PATIENCE).ignoreExceptionsInstanceOf(RemoteException.class);
  }

  private int fixes(long fromEpoch) {
    return (int)
        received.stream()
            .filter(each -> each.kind() == EventKind.READING && each.epoch() >= fromEpoch)
            .count();
  }

  private static void signal(String name, long pid) throws Exception {
    Process kill = new ProcessBuilder("kill", "-" + name, Long.toString(pid)).start();
    assertThat(kill.waitFor()).isZero();
  }
}
