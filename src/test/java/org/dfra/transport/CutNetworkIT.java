package org.dfra.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.core.time.Timing;
import org.dfra.testing.NetworkNamespaceHosts;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * The network between a client and a server is cut silently, as radio is, in each phase of a call,
 * and restored.
 */
@Timeout(120)
class CutNetworkIT {

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  /** The deadline of a call, 2 s, and 0.1 s for its timer and its thread. */
  private static final Duration FREE = Duration.ofMillis(2100);

  /** A call after the network was restored: on a new connection, which needs no retransmission. */
  private static final Duration ANSWERED = Duration.ofSeconds(1);

  /** Longer than the operating system waits, after a cut of 2 s, before it sends bytes again. */
  private static final Duration RETRANSMITTED = Duration.ofSeconds(5);

  /** A client says that it pauses after 0.3 s, and its watchdog looks each 0.25 s. */
  private static final Duration PAUSED = Duration.ofSeconds(1);

  private static NetworkNamespaceHosts network;
  private static TaskProcess server;
  private static TaskProcess client;

  /** What a call does when the network is cut. */
  enum Phase {
    /** It has no connection yet. */
    CONNECTING("count"),
    /** Its request is not on the way yet; a thread of the server waits for it. */
    SENDING("count"),
    /** Its request is not on the way yet; the server expects none soon, but for a minute. */
    SENDING_AFTER_A_PAUSE("count"),
    /** Half of its request has been sent. */
    HALF_SENT("take"),
    /** The object executes it. */
    EXECUTING("hold"),
    /** Half of its response has been sent. */
    HALF_READ("give");

    private final String command;

    Phase(String command) {
      this.command = command;
    }

    boolean hasRun() {
      return this == EXECUTING || this == HALF_READ;
    }

    boolean ends(String outcome) {
      return outcome.equals(this == CONNECTING ? "late-has-not-run" : "late-may-have-run");
    }
  }

  /** How a call ended. */
  private record Outcome(String word, Timing timing) {

    static Outcome read() throws Exception {
      String[] words = client.awaitLine("ended ", PATIENCE).split(" ");
      return new Outcome(
          words[1],
          new Timing(
              Duration.ofNanos(Long.parseLong(words[2])),
              Duration.ofNanos(Long.parseLong(words[3])),
              Double.parseDouble(words[4]),
              Duration.ofNanos(Long.parseLong(words[5]))));
    }
  }

  @BeforeAll
  static void start() throws Exception {
    Optional<String> refusal = NetworkNamespaceHosts.unavailableReason();
    assumeTrue(refusal.isEmpty(), () -> refusal.orElse(""));
    network = new NetworkNamespaceHosts();
    server =
        TaskProcess.start(
            network.commandPrefix(1),
            List.of(),
            CountingTask.class,
            "tcp",
            NetworkNamespaceHosts.ADDRESSES.get(1));
    String proxy = server.awaitLine("proxy ", PATIENCE).substring("proxy ".length());
    client = TaskProcess.start(network.commandPrefix(0), List.of(), CallingTask.class, proxy);
    for (Phase each : Phase.values()) { // classes are loaded, and each thread has been started
      Outcome unused = uncut(each);
    }
  }

  @AfterAll
  static void end() throws Exception {
    try (NetworkNamespaceHosts removed = network;
        TaskProcess one = client;
        TaskProcess other = server) {
      assertThat(one == null).isEqualTo(other == null);
    }
  }

  private static Outcome call(String command) throws Exception {
    client.write(command);
    return Outcome.read();
  }

  private static int counted() throws Exception {
    Outcome outcome = call("counted");
    assertThat(outcome.word()).startsWith("answered-");
    return Integer.parseInt(outcome.word().substring("answered-".length()));
  }

  private static Outcome uncut(Phase phase) throws Exception {
    begin(phase);
    goOn(phase);
    Outcome outcome = Outcome.read();
    assertThat(outcome.word()).as("%s, without a cut", phase).startsWith("answered-");
    return outcome;
  }

  /** Leads a call to its phase; those that have none to wait in begin with the cut. */
  private static void begin(Phase phase) throws Exception {
    if (phase == Phase.CONNECTING) {
      client.write("close");
      return;
    } else if (phase == Phase.SENDING) {
      int unused = counted();
      return;
    } else if (phase == Phase.SENDING_AFTER_A_PAUSE) {
      int unused = counted();
      await("the client has said that it pauses").pollDelay(PAUSED).until(() -> true);
      return;
    }
    client.write(phase.command);
    String unused =
        switch (phase) {
          case HALF_SENT -> client.awaitLine("half", PATIENCE);
          case EXECUTING -> server.awaitLine("executes", PATIENCE);
          default -> server.awaitLine("half", PATIENCE);
        };
  }

  private static void goOn(Phase phase) throws Exception {
    switch (phase) {
      case CONNECTING, SENDING, SENDING_AFTER_A_PAUSE -> client.write(phase.command);
      case HALF_SENT -> client.write("go");
      default -> server.write("go");
    }
  }

  private static int threads() throws Exception {
    client.write("threads");
    return Integer.parseInt(client.awaitLine("threads ", PATIENCE).split(" ")[1]);
  }

  @ParameterizedTest
  @EnumSource(Phase.class)
  void aCallEndsInTimeAndIsNotRunLaterAndTheNextOneAfterTheCutIsAnsweredAtOnce(Phase phase)
      throws Exception {
    int before = counted();
    int threads = threads();
    begin(phase);
    network.disconnect();
    Outcome late;
    try {
      if (phase != Phase.EXECUTING) { // its object returns when the network is back
        goOn(phase);
      }
      late = Outcome.read();
      assertThat(threads()).as("threads").isLessThanOrEqualTo(threads);
    } finally {
      network.reconnect();
    }
    Outcome next = call("counted");
    int ran = phase.hasRun() ? 1 : 0;
    assertThat(late.word()).matches(phase::ends);
    assertThat(next.word()).isEqualTo("answered-" + (before + ran));
    if (phase == Phase.EXECUTING) {
      goOn(phase);
    }
    await("nothing runs later")
        .during(RETRANSMITTED)
        .atMost(RETRANSMITTED.plus(PATIENCE))
        .pollInterval(Duration.ofMillis(500))
        .until(() -> counted() == before + ran);
    System.out.printf(
        "cut while %s: the call ended after %d ms, the next one was answered in %d ms%n",
        phase, late.timing().took().toMillis(), next.timing().took().toMillis());
    late.timing().requireWithin("a call, cut while " + phase + ",", FREE);
    next.timing().requireWithin("the next call after a cut while " + phase, ANSWERED);
  }

  @ParameterizedTest
  @EnumSource(Phase.class)
  void aCallOutlastsABriefCut(Phase phase) throws Exception {
    int before = counted();
    begin(phase);
    network.disconnect();
    try {
      goOn(phase);
    } finally {
      network.reconnect();
    }
    Outcome outcome = Outcome.read();
    System.out.printf(
        "cut briefly while %s: %s in %d ms%n",
        phase, outcome.word(), outcome.timing().took().toMillis());
    outcome
        .timing()
        .requireWithin("a call, cut briefly while " + phase + ",", FREE.minusMillis(200));
    assertThat(outcome.word()).isEqualTo("answered-" + before);
    assertThat(counted()).isEqualTo(before + 1);
  }
}
