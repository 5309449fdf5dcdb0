package org.dfra.river.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicReference;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Every call ends, whatever happens to its server. */
class DeadlineTest {

  /** What is served here. */
  public interface Service extends Remote {
    String echo(String text) throws RemoteException;

    void block() throws RemoteException;

    void fail() throws RemoteException, IOException;
  }

  /** After a deadline, for the timer, the threads, and classes that are needed the first time. */
  private static final Duration MARGIN = Duration.ofMillis(200);

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final CountDownLatch blocked = new CountDownLatch(1);
  private final CountDownLatch release = new CountDownLatch(1);
  private final ExecutorService threads = Executors.newCachedThreadPool();
  private final List<AutoCloseable> open = new ArrayList<>();
  private final StallProbe probe = StallProbe.start();

  private final class Server implements Service {
    @Override
    public String echo(String text) {
      return text;
    }

    @Override
    public void block() {
      blocked.countDown();
      try {
        release.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }

    @Override
    public void fail() throws IOException {
      throw new IOException("in its own words");
    }
  }

  private Server server; // JERI holds it only weakly

  private Service export(long deadlineMillis) throws Exception {
    BasicJeriExporter exporter =
        new BasicJeriExporter(
            Endpoints.tcp("127.0.0.1", 0), new DeadlineILFactory(deadlineMillis), false, true);
    open.add(() -> exporter.unexport(true));
    server = new Server();
    return (Service) exporter.export(server);
  }

  @AfterEach
  void end() throws Exception {
    probe.close();
    release.countDown();
    threads.shutdownNow();
    for (AutoCloseable each : open) {
      each.close();
    }
  }

  @Test
  void answerAndFailureArriveAsTheyAre() throws Exception {
    Service service = export(20_000);
    assertThat(service.echo("hello")).isEqualTo("hello");
    assertThatExceptionOfType(IOException.class)
        .isThrownBy(service::fail)
        .withMessage("in its own words");
  }

  @Test
  void callThatIsNotAnsweredEndsAtItsDeadlineAndSaysThatItMayHaveRun() throws Exception {
    Service service = export(200);
    await("connected").atMost(PATIENCE).until(() -> works(service));
    StallProbe.Stopwatch began = probe.stopwatch();
    assertThatExceptionOfType(DeadlineExceededException.class)
        .isThrownBy(service::block)
        .withMessageContaining("Service.block on TcpEndpoint")
        .withMessageContaining("got no answer within 200 ms; it may have run")
        .satisfies(e -> assertThat(e.mayHaveRun()).isTrue());
    Timing ended = began.stop();
    assertThat(ended.took()).isGreaterThan(Duration.ofMillis(190));
    await("others go on").atMost(PATIENCE).until(() -> works(service));
    ended.requireWithin("a call with a deadline of 200 ms", MARGIN.plusMillis(200));
  }

  @Test
  void interruptedCallerIsFreeAtOnceAndStaysInterrupted() throws Exception {
    Service service = export(20_000);
    AtomicReference<Throwable> seen = new AtomicReference<>();
    AtomicReference<Boolean> flag = new AtomicReference<>();
    Thread caller =
        new Thread(
            () -> {
              try {
                service.block();
              } catch (RemoteException e) {
                seen.set(e);
              }
              flag.set(Thread.currentThread().isInterrupted());
            });
    caller.start();
    blocked.await();
    StallProbe.Stopwatch interrupted = probe.stopwatch();
    caller.interrupt();
    caller.join(PATIENCE.toMillis());
    interrupted.stop().requireWithin("the end of an interrupted call", MARGIN);
    assertThat(seen.get())
        .isInstanceOf(CallInterruptedException.class)
        .hasMessageContaining("was interrupted while it waited for its answer; it may have run");
    assertThat(flag.get()).as("still interrupted").isTrue();
  }

  @Test
  void peerThatTakesConnectionsAndNeverAnswersIsReportedAndHoldsSoManyThreads() throws Exception {
    ServerSocket mute = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    open.add(mute);
    Service service = proxy(mute.getLocalPort(), 150);
    StallProbe.Stopwatch began = probe.stopwatch();
    assertNotRun(service);
    Timing ended = began.stop();
    List<Future<?>> callers = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      callers.add(threads.submit(() -> assertNotRun(service)));
    }
    for (Future<?> each : callers) {
      each.get();
    }
    assertThatExceptionOfType(DeadlineExceededException.class)
        .isThrownBy(
            () -> {
              for (int i = 0;
                  i <= DeadlineInvocationHandler.UnresponsivePeers.MAX_BLOCKED_THREADS;
                  i++) {
                service.echo("x");
              }
            })
        .satisfies(e -> assertThat(e.mayHaveRun()).isFalse());
    assertThat(export(20_000).echo("other peers")).isEqualTo("other peers");
    // When the peer goes away its threads come free, and it is tried again.
    mute.close();
    ended.requireWithin("a call with a deadline of 150 ms", MARGIN.plusMillis(150));
  }

  @Test
  void peerThatAnswersSlowlyIsAwaitedLongerThanOneThatCannotBeReached() throws Exception {
    Duration deadline = Duration.ofMinutes(2); // as for an activation, which starts a process
    Service slow = export(deadline.toMillis());
    Future<?> call =
        threads.submit(
            () -> {
              slow.block();
              return null;
            });
    blocked.await();
    ServerSocket mute = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    open.add(mute);
    StallProbe.Stopwatch began = probe.stopwatch();
    assertThatExceptionOfType(DeadlineExceededException.class)
        .isThrownBy(() -> proxy(mute.getLocalPort(), deadline.toMillis()).echo("x"))
        .withMessageContaining("got no answer within 2000 ms; it has not run");
    Timing ended = began.stop();

    assertThatExceptionOfType(TimeoutException.class)
        .as("the other one, a second longer")
        .isThrownBy(() -> call.get(1, TimeUnit.SECONDS));
    release.countDown();
    assertThat(call.get()).isNull();
    ended.requireWithin("a call to a peer that cannot be connected to", MARGIN.plusSeconds(2));
  }

  @Test
  void peerThatTakesNoConnectionIsReportedInTimeAndItsThreadsAreBounded() throws Exception {
    // A listener whose queue is full: the operating system drops further connections unanswered.
    ServerSocket full = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    open.add(full);
    for (int i = 0; i < 4; i++) {
      Socket waiting = new Socket();
      open.add(waiting);
      threads.submit(
          () -> {
            waiting.connect(
                new InetSocketAddress(full.getInetAddress(), full.getLocalPort()), 2000);
            return null;
          });
    }
    Service service = proxy(full.getLocalPort(), 20);
    boolean refused = false;
    for (int i = 0; i < 200 && !refused; i++) { // each holds its thread until connecting fails
      StallProbe.Stopwatch began = probe.stopwatch();
      try {
        service.echo("x");
      } catch (DeadlineExceededException e) {
        assertThat(e.mayHaveRun()).isFalse();
        refused = e.getMessage().contains("was not tried");
      }
      began.stop().requireWithin("call " + i + " with a deadline of 20 ms", MARGIN.plusMillis(20));
    }
    assertThat(refused).as("a call was not even tried").isTrue();
    assertThat(export(20_000).echo("other peers")).isEqualTo("other peers");
  }

  @Test
  void connectionToAHostThatTakesNoMoreOfThemIsClosedAfterTheDeadline() throws Exception {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      Future<?> call = threads.submit(() -> assertNotRun(proxy(server.getLocalPort(), 1500)));
      try (Socket connection = server.accept()) {
        fill(server);
        call.get();
        connection.setSoTimeout(30_000);
        assertThat(connection.getInputStream().readAllBytes())
            .as("what came before the client closed it")
            .isNotEmpty();
      }
    }
  }

  @Test
  void connectionToAProcessThatIsOnlySlowIsLeftAlone() throws Exception {
    try (ServerSocket server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress())) {
      Future<?> call = threads.submit(() -> assertNotRun(proxy(server.getLocalPort(), 200)));
      try (Socket connection = server.accept();
          Socket probe = server.accept()) {
        call.get();
        assertThat(probe.getInputStream().read()).as("nothing is sent").isEqualTo(-1);
        connection.setSoTimeout(500);
        assertThatExceptionOfType(SocketTimeoutException.class)
            .isThrownBy(() -> connection.getInputStream().readAllBytes());
      }
    }
  }

  /** Until the operating system takes no further connections for the server. */
  private void fill(ServerSocket server) throws IOException {
    while (true) {
      Socket waiting = new Socket();
      open.add(waiting);
      try {
        waiting.connect(server.getLocalSocketAddress(), 300);
      } catch (SocketTimeoutException e) {
        return;
      }
    }
  }

  private static void assertNotRun(Service service) {
    assertThatExceptionOfType(DeadlineExceededException.class)
        .isThrownBy(() -> service.echo("x"))
        .satisfies(
            e -> {
              assertThat(e.mayHaveRun()).isFalse();
              assertThat(e.getMessage()).containsAnyOf("it has not run", "was not tried");
            });
  }

  static Service proxy(int port, long deadlineMillis) {
    return (Service)
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(
                Endpoints.tcpClient("127.0.0.1", port), UuidFactory.generate(), false),
            Duration.ofMillis(deadlineMillis),
            DeadlineTest.class.getClassLoader(),
            Service.class,
            RemoteMethodControl.class);
  }

  @Test
  void silentPeersCountUpAndDown() {
    DeadlineInvocationHandler.UnresponsivePeers peers =
        new DeadlineInvocationHandler.UnresponsivePeers();
    assertThat(peers.blockedThreads("a")).isZero();
    peers.addBlockedThread("a");
    peers.addBlockedThread("a");
    peers.addBlockedThread("b");
    assertThat(peers.blockedThreads("a")).isEqualTo(2);
    peers.removeBlockedThread("a");
    peers.removeBlockedThread("a");
    peers.removeBlockedThread("a");
    assertThat(peers.blockedThreads("a")).isZero();
    assertThat(peers.blockedThreads("b")).isEqualTo(1);
  }

  @Test
  void threadsThatAPeerHeldAreLetGoWhenItAnswers() throws Exception {
    Service service = export(100);
    for (int i = 0; i < DeadlineInvocationHandler.UnresponsivePeers.MAX_BLOCKED_THREADS / 2; i++) {
      assertThatExceptionOfType(DeadlineExceededException.class).isThrownBy(service::block);
    }
    release.countDown();
    await("calls get through again").atMost(PATIENCE).until(() -> works(service));
  }

  private static boolean works(Service service) {
    try {
      return service.echo("x").equals("x");
    } catch (RemoteException e) {
      return false;
    }
  }

  static Service received(Service sent) throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(sent);
    }
    return (Service)
        new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray())).readObject();
  }

  @Test
  void proxyKeepsItsDeadlineAcrossTheWireAndUnderConstraints() throws Exception {
    Service service = export(300);
    Service read = received(service);
    assertThat(read).isEqualTo(service).hasSameHashCodeAs(service);
    assertThat(Proxy.getInvocationHandler(read)).isInstanceOf(DeadlineInvocationHandler.class);
    Service constrained = (Service) ((RemoteMethodControl) read).setConstraints(null);
    StallProbe.Stopwatch began = probe.stopwatch();
    assertThatExceptionOfType(DeadlineExceededException.class)
        .isThrownBy(constrained::block)
        .withMessageContaining("300 ms");
    began.stop().requireWithin("a call with a deadline of 300 ms", MARGIN.plusMillis(300));
  }

  @Test
  void aPermissionClassIsRefusedSinceItWouldGuardNothing() {
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                new DeadlineILFactory(
                    null, RuntimePermission.class, null, DeadlineILFactory.DEFAULT_DEADLINE))
        .withMessage(
            "permission class java.lang.RuntimePermission would guard nothing, since there is no"
                + " security manager; mark what only administrators may call with @Administrative,"
                + " and name them in <administration from=\"…\"> of the robot's XML");
  }

  @Test
  void deadlineShorterThanAMillisecondIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new DeadlineILFactory(0))
        .withMessage("deadline PT0S is shorter than 1 ms");
    assertThat(new DeadlineILFactory(5)).isEqualTo(new DeadlineILFactory(5));
    assertThat(new DeadlineILFactory(5)).isNotEqualTo(new DeadlineILFactory(6));
  }
}
