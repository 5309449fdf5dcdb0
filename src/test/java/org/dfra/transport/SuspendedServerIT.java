package org.dfra.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayInputStream;
import java.io.ObjectInputStream;
import java.rmi.RemoteException;
import java.rmi.UnmarshalException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Collectors;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.river.call.CallInterruptedException;
import org.dfra.river.call.DeadlineExceededException;
import org.dfra.transport.CountingTask.Counter;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A server whose process is suspended, killed or slow, called by TCP and by a local socket. */
@Timeout(120)
class SuspendedServerIT {

  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final Duration DEADLINE = Duration.ofSeconds(2);
  private static final Duration FREE = Duration.ofMillis(2100);
  private static final int CALLERS = 40;

  private final StallProbe probe = StallProbe.start();
  private final ExecutorService callers = Executors.newCachedThreadPool();
  private TaskProcess process;
  private Counter counter;

  private void start(String transport) throws Exception {
    process = TaskProcess.start(CountingTask.class, transport, "127.0.0.1");
    String line = process.awaitLine("proxy ", PATIENCE);
    byte[] bytes = Base64.getDecoder().decode(line.substring("proxy ".length()));
    try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes))) {
      counter = (Counter) in.readObject();
    }
    assertThat(counter.count()).isZero();
  }

  @AfterEach
  void end() throws Exception {
    probe.close();
    callers.shutdownNow();
    if (process != null) {
      process.close();
    }
  }

  private void signal(String signal) throws Exception {
    Process kill = new ProcessBuilder("kill", "-" + signal, "" + process.pid()).start();
    assertThat(kill.waitFor()).isZero();
  }

  /** Calls from so many threads at once; their failures. */
  private List<Throwable> callAtOnce(int count, Callable<?> call) throws Exception {
    CountDownLatch ready = new CountDownLatch(count);
    List<Future<Throwable>> calls = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      calls.add(
          callers.submit(
              () -> {
                ready.countDown();
                ready.await();
                try {
                  Object unused = call.call();
                  return new AssertionError("it was answered");
                } catch (RemoteException e) {
                  return e;
                }
              }));
    }
    List<Throwable> failures = new ArrayList<>();
    for (Future<Throwable> each : calls) {
      failures.add(each.get(30, TimeUnit.SECONDS));
    }
    return failures;
  }

  /**
   * The threads that calls of clients use. Those of lookups that earlier tests of this virtual
   * machine have left come and go by themselves.
   */
  private static Set<String> callThreads() {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(each -> each.matches("dfra-(call|resolver|watchdog).*"))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  @ParameterizedTest
  @ValueSource(strings = {"tcp", "local"})
  void allCallersAreFreeInTimeHoweverManyConnectionsWaitAndNothingRunsLater(String transport)
      throws Exception {
    start(transport);
    Set<String> threads = callThreads();
    signal("STOP");
    List<Timing> rounds = new ArrayList<>();
    int mayHaveRun = 0;
    for (int round = 0; round < 5; round++) { // more connections than a backlog has room for
      StallProbe.Stopwatch began = probe.stopwatch();
      for (Throwable each : callAtOnce(CALLERS, () -> counter.count())) {
        if (each instanceof DeadlineExceededException late) {
          mayHaveRun += late.mayHaveRun() ? 1 : 0;
        } else { // a full backlog of a local socket refuses at once
          assertThat(each).isInstanceOf(java.rmi.ConnectException.class);
        }
      }
      rounds.add(began.stop());
    }
    assertThat(threads).as("threads").containsAll(callThreads());
    assertThat(mayHaveRun).as("calls on the connection that was open before").isLessThan(2);
    signal("CONT");
    int before = mayHaveRun + 1; // with the first one
    await("it answers again")
        .atMost(PATIENCE)
        .ignoreExceptionsInstanceOf(RemoteException.class)
        .until(() -> counter.counted() <= before);
    for (Timing each : rounds) {
      each.requireWithin(CALLERS + " callers of a suspended server", FREE);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"tcp", "local"})
  void aCallerIsInterruptedAtOnceInEachPhase(String transport) throws Exception {
    start(transport);
    interrupted("while it executes", () -> counter.block(), 300);
    signal("STOP");
    assertThatThrownBy(() -> counter.count()).isInstanceOf(DeadlineExceededException.class);
    interrupted("while it is greeted", () -> counter.count(), 300);
    assertThatThrownBy(() -> counter.bytes(1)).isInstanceOf(DeadlineExceededException.class);
    signal("CONT");
    await("it answers again")
        .atMost(PATIENCE)
        .ignoreExceptionsInstanceOf(RemoteException.class)
        .until(() -> counter.bytes(1 << 20).length == 1 << 20);
  }

  /** An action of a test. */
  private interface Call {
    void run() throws RemoteException;
  }

  private void interrupted(String phase, Call call, long afterMillis) throws Exception {
    CountDownLatch begins = new CountDownLatch(1);
    Thread[] caller = new Thread[1];
    Future<Throwable> failure =
        callers.submit(
            () -> {
              caller[0] = Thread.currentThread();
              begins.countDown();
              try {
                call.run();
                return null;
              } catch (RemoteException e) {
                assertThat(Thread.interrupted()).as("the flag, " + phase).isTrue();
                return e;
              }
            });
    begins.await();
    assertThatThrownBy(() -> failure.get(afterMillis, TimeUnit.MILLISECONDS))
        .as(phase)
        .isInstanceOf(java.util.concurrent.TimeoutException.class);
    StallProbe.Stopwatch began = probe.stopwatch();
    caller[0].interrupt();
    assertThat(failure.get(30, TimeUnit.SECONDS))
        .as(phase)
        .isInstanceOf(CallInterruptedException.class);
    began.stop().requireWithin("the end of a call interrupted " + phase, Duration.ofMillis(200));
  }

  @ParameterizedTest
  @ValueSource(strings = {"tcp", "local"})
  void aKilledServerIsReportedAtOnce(String transport) throws Exception {
    start(transport);
    Future<Throwable> executing =
        callers.submit(
            () -> {
              try {
                counter.block();
                return null;
              } catch (RemoteException e) {
                return e;
              }
            });
    assertThat(counter.count()).isEqualTo(1);
    process.close();
    assertThat(executing.get(10, TimeUnit.SECONDS)).isInstanceOf(RemoteException.class);
    StallProbe.Stopwatch began = probe.stopwatch();
    assertThatThrownBy(() -> counter.count()).isInstanceOf(RemoteException.class);
    assertThatThrownBy(() -> counter.count()).isInstanceOf(java.rmi.ConnectException.class);
    began.stop().requireWithin("the report of a killed server", DEADLINE.dividedBy(4));
  }

  /** The failure of a call whose server has sent half of the response. */
  private Future<Throwable> halfAnswered(AtomicReference<Timing> took) throws Exception {
    Future<Throwable> failure =
        callers.submit(
            () -> {
              StallProbe.Stopwatch began = probe.stopwatch();
              try {
                return new AssertionError("it was answered: " + counter.give());
              } catch (RemoteException e) {
                return e;
              } finally {
                took.set(began.stop());
              }
            });
    String unused = process.awaitLine("half", PATIENCE);
    return failure;
  }

  @ParameterizedTest
  @ValueSource(strings = {"tcp", "local"})
  void aServerThatIsSuspendedInTheMiddleOfItsResponseIsLeftInTime(String transport)
      throws Exception {
    start(transport);
    Set<String> threads = callThreads();
    AtomicReference<Timing> took = new AtomicReference<>();
    Future<Throwable> failure = halfAnswered(took);
    signal("STOP");
    assertThat(failure.get(30, TimeUnit.SECONDS))
        .isInstanceOfSatisfying(
            DeadlineExceededException.class, e -> assertThat(e.mayHaveRun()).isTrue());
    assertThat(threads).as("threads").containsAll(callThreads());
    signal("CONT");
    process.write("go");
    StallProbe.Stopwatch began = probe.stopwatch();
    assertThat(counter.count()).as("calls before, each once").isEqualTo(2);
    Timing next = began.stop();
    took.get().requireWithin("a call whose server is suspended while it answers", FREE);
    next.requireWithin("the next call after the server continues", Duration.ofSeconds(1));
  }

  @ParameterizedTest
  @ValueSource(strings = {"tcp", "local"})
  void aServerThatIsKilledInTheMiddleOfItsResponseIsReportedAtOnce(String transport)
      throws Exception {
    start(transport);
    Future<Throwable> failure = halfAnswered(new AtomicReference<>());
    StallProbe.Stopwatch began = probe.stopwatch();
    process.close();
    assertThat(failure.get(30, TimeUnit.SECONDS))
        .as("not a failure that says that it has not run")
        .isInstanceOf(UnmarshalException.class);
    Timing reported = began.stop();
    assertThatThrownBy(() -> counter.count()).isInstanceOf(java.rmi.ConnectException.class);
    reported.requireWithin("the report of a server killed while it answers", DEADLINE.dividedBy(4));
  }
}
