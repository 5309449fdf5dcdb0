package org.dfra.secure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;
import static org.dfra.secure.SecureTeam.ANNA;
import static org.dfra.secure.SecureTeam.ok;

import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.core.policy.BuiltInPolicies;
import org.dfra.drive.Wheels;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.module.NotReadyException;
import org.dfra.river.call.CallbackHost;
import org.dfra.security.AccessRefusedException;
import org.dfra.sim.device.gps.M12Emulator;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A robot of a team whose policy has budgets, an operator, and observers that want too much. */
@Timeout(300)
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class BudgetIT {

  private static final String ROBOT = "atrv1";
  private static final String OTTO = "otto";
  private static final String OLIVIA = "olivia";
  private static final String BUDGETS =
      """
        <budget name="observers" role="observer" calls="40/s" bytes="100kB/s" listeners="3"/>
        <budget name="operators" role="operator" calls="5000/s"/>
        <radio max="2kB/s"/>
      """;
  private static final int CALLS_PER_SECOND = 40;
  private static final Duration FLOOD = Duration.ofSeconds(4);
  private static final int OPERATORS_CALLS = 200;
  private static final long SLACK_MICROS = 20_000; // other tests use the processors too

  @TempDir static Path folder;

  private static SecureTeam team;
  private static Wheels wheels;
  private static M12Emulator receiver;
  private static MemberCalls anna;
  private static MemberCalls otto;
  private static MemberCalls olivia;

  @BeforeAll
  static void make() throws Exception {
    wheels = new Wheels();
    receiver = TeamRobots.receiver();
    team = new SecureTeam(folder);
    team.describe(
        ROBOT,
        TeamRobots.group(
            "all",
            TeamRobots.registrar(),
            TeamRobots.gps(receiver.url()),
            TeamRobots.drive(wheels.url()),
            odometry(wheels.url())));
    team.init();
    Path policy = team.state(ANNA).resolve("authority").resolve("policy.xml");
    String standard = BuiltInPolicies.standardText("field", 5);
    Path unused = Files.writeString(policy, standard.replace("</policy>", BUDGETS + "</policy>"));
    team.admit("robot", ROBOT);
    team.admit("observer", OTTO);
    team.admit("observer", OLIVIA);
    ok(team.up(ROBOT));
    anna = new MemberCalls(team.security(ANNA));
    otto = new MemberCalls(team.security(OTTO));
    olivia = new MemberCalls(team.security(OLIVIA));
  }

  @AfterAll
  static void end() {
    try {
      team.close();
    } finally {
      receiver.close();
      wheels.close();
    }
  }

  /** Ten readings a second. */
  private static String odometry(String link) {
    return """
    <module name="odometry" properties="%s/config/modules/rflex-odometry.properties">
      <parameter name="link" value="%s"/>
    </module>
    """
        .formatted(System.getProperty("dfra.root"), link);
  }

  private static GPSSensor gps(MemberCalls who) throws Exception {
    return who.find(team.registrar(ROBOT), GPSSensor.class, "atrv1/gps_front");
  }

  /** Median and 99 % of the times of calls, in microseconds. */
  private static long[] latency(GPSSensor gps) throws Exception {
    long[] times = new long[OPERATORS_CALLS];
    for (int i = 0; i < times.length; i++) {
      long begun = System.nanoTime();
      Object unused = gps.fix();
      times[i] = (System.nanoTime() - begun) / 1000;
    }
    Arrays.sort(times);
    return new long[] {times[times.length / 2], times[times.length * 99 / 100]};
  }

  /** Calls as often as it can, from several threads, until closed. */
  private static final class Flood implements AutoCloseable {

    final AtomicLong permitted = new AtomicLong();
    final AtomicLong refused = new AtomicLong();
    private final AtomicBoolean isOver = new AtomicBoolean();
    private final List<Thread> threads = new ArrayList<>();
    private final ConcurrentLinkedQueue<Throwable> failures = new ConcurrentLinkedQueue<>();
    private volatile String sentence = "";

    Flood(GPSSensor gps, int callers) {
      for (int i = 0; i < callers; i++) {
        Thread thread = new Thread(() -> run(gps), "greedy observer " + i);
        threads.add(thread);
        thread.start();
      }
    }

    private void run(GPSSensor gps) {
      while (!isOver.get()) {
        try {
          Object unused = gps.fix();
          permitted.incrementAndGet();
        } catch (AccessRefusedException e) {
          sentence = String.valueOf(e.getMessage());
          refused.incrementAndGet();
        } catch (RemoteException | RuntimeException e) {
          failures.add(e);
          return;
        }
      }
    }

    @Override
    public void close() throws InterruptedException {
      isOver.set(true);
      for (Thread each : threads) {
        each.join();
      }
      assertThat(failures).as("calls that failed and were not refused").isEmpty();
    }
  }

  @Test
  @Order(1)
  void refusesAGreedyObserverWhileOthersGoOn() throws Exception {
    GPSSensor annas = gps(anna);
    GPSSensor olivias = gps(olivia);
    long[] quiet = latency(annas);
    long begun = System.nanoTime();
    long[] beside;
    try (Flood flood = new Flood(gps(otto), 2)) {
      beside = latency(annas);
      for (int i = 0; i < CALLS_PER_SECOND / 2; i++) { // another observer has a budget of its own
        assertThat(olivias.fix()).isNotNull();
      }
      await()
          .atMost(FLOOD.multipliedBy(10))
          .until(() -> System.nanoTime() - begun > FLOOD.toNanos());
      flood.close();
      double seconds = (System.nanoTime() - begun) / 1e9;
      System.out.printf(
          "greedy observer: %d of %d calls/s in %.1f s permitted; operator's call %d µs, p99 %d µs,"
              + " beside it %d µs, p99 %d µs%n",
          flood.permitted.get(),
          (long) ((flood.permitted.get() + flood.refused.get()) / seconds),
          seconds,
          quiet[0],
          quiet[1],
          beside[0],
          beside[1]);
      assertThat(flood.sentence)
          .contains(
              "GPSSensor.fix of gps_front is refused to observer otto of field (127.0.0.1) by rule"
                  + " budget observers: observer otto has used up the 40 calls/s that it allows"
                  + " each caller; call less often, again in 1 s at the latest");
      assertThat((double) flood.permitted.get())
          .as("a second's calls at first, then %s in each", CALLS_PER_SECOND)
          .isLessThanOrEqualTo(CALLS_PER_SECOND * (seconds + 1.5));
      assertThat(flood.refused.get()).isGreaterThan(flood.permitted.get());
      assertThat(beside[0])
          .as(
              "median of the operator's calls in µs, beside the greedy observer's; alone %s",
              quiet[0])
          .isLessThan(10 * quiet[0] + SLACK_MICROS);
    }
  }

  @Test
  @Order(2)
  void stopsAtOnceThoughItsBudgetIsUsedUp() throws Exception {
    GPSSensor ottos = gps(otto);
    try (Flood flood = new Flood(ottos, 1)) {
      await().until(() -> flood.refused.get() > 0);
      String phoenix = "--phoenix=" + SecureTeam.HOST + ":" + team.phoenix(ROBOT).port();
      ok(team.ask(OTTO, "stop", ROBOT, phoenix));
    }
  }

  @Test
  @Order(3)
  void refusesAFurtherListenerAndShowsWhatWasUsed() throws Exception {
    GPSSensor ottos = gps(otto);
    AtomicLong events = new AtomicLong();
    List<Subscription> held = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      held.add(subscribed(ottos, event -> events.incrementAndGet()));
    }
    assertThatThrownBy(() -> subscribed(ottos, event -> {}))
        .isInstanceOf(NotReadyException.class)
        .hasMessageContaining("observer otto has 3 of at most 3 listeners of budget observers");
    await().until(() -> events.get() > 0);
    String table = ok(team.dfra(ROBOT, "status", "--budget")).out();
    System.out.println(table);
    assertThat(table).contains("observers", "observer otto", "3 of 3", "of 100", "of 40");
    assertThat(table.replaceAll("\\s+", " "))
        .as("the stop went to phoenix")
        .contains("GROUP phoenix BUDGET observers USED BY observer otto");
    String json = ok(team.dfra(ROBOT, "status", "--budget", "--json")).out();
    assertThat(json).contains("\"owner\"", "observer otto", "\"maxCalls\"");
    for (Subscription each : held) {
      each.close();
    }
  }

  /** Counts what it misses. At an address that stands for another computer. */
  private static final class MissingReadings implements ModuleListener {

    private static final String OTHER_COMPUTER = "127.0.0.2";

    final AtomicLong received = new AtomicLong();
    final AtomicLong missed = new AtomicLong();
    final AtomicLong firstMissed = new AtomicLong(Long.MAX_VALUE);

    @Override
    public void notify(Delivery delivery) {
      received.incrementAndGet();
      if (missed.addAndGet(delivery.dropped()) > 0) {
        firstMissed.compareAndSet(Long.MAX_VALUE, System.nanoTime());
      }
    }

    Subscription listen(MemberCalls who) throws Exception {
      String before = System.getProperty(CallbackHost.PROPERTY);
      System.setProperty(CallbackHost.PROPERTY, OTHER_COMPUTER);
      try {
        OdometrySensor odometry =
            who.find(team.registrar(ROBOT), OdometrySensor.class, "atrv1/odometry");
        return who.call(() -> odometry.subscribe(this, DeliveryPolicy.keepLast(64)));
      } finally {
        if (before == null) {
          System.clearProperty(CallbackHost.PROPERTY);
        } else {
          System.setProperty(CallbackHost.PROPERTY, before);
        }
      }
    }
  }

  @Test
  @Order(4)
  void anObserverGetsFewerReadingsBeforeAnOperatorDoesWhenTheRadioIsFull() throws Exception {
    MissingReadings observers = new MissingReadings();
    MissingReadings operators = new MissingReadings();
    try (Subscription unused = operators.listen(anna);
        Subscription unusedToo = observers.listen(olivia)) {
      await().atMost(SecureTeam.PATIENCE).until(() -> observers.missed.get() > 20);
      assertThat(observers.firstMissed.get()).isLessThan(operators.firstMissed.get());
      await().atMost(SecureTeam.PATIENCE).until(() -> operators.missed.get() > 20);
      System.out.printf(
          "full radio: the observer missed %d of %d readings, the operator %d of %d%n",
          observers.missed.get(),
          observers.missed.get() + observers.received.get(),
          operators.missed.get(),
          operators.missed.get() + operators.received.get());
      String table = ok(team.dfra(ROBOT, "status", "--budget", ROBOT)).out();
      assertThat(table)
          .contains("atrv1.all: the radio carries", "of 2 kB/s", "observers get one reading in");
    }
  }

  /** A call that is refused for its rate is repeated. */
  private static Subscription subscribed(GPSSensor ottos, ModuleListener listener) {
    return await()
        .ignoreExceptionsInstanceOf(AccessRefusedException.class)
        .until(
            () -> otto.call(() -> ottos.subscribe(listener, DeliveryPolicy.keepLast(8))),
            each -> true);
  }
}
