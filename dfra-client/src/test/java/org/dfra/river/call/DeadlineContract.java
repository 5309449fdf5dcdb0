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
import java.net.ServerSocket;
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
import net.jini.jeri.Endpoint;
import net.jini.jeri.ServerEndpoint;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Every call ends, whatever happens to its server and whatever the transport. */
abstract class DeadlineContract {

  /** What is served here. */
  public interface Service extends Remote {
    String echo(String text) throws RemoteException;

    void block() throws RemoteException;

    void fail() throws RemoteException, IOException;
  }

  /** After a deadline, for the timer, the threads, and classes that are needed the first time. */
  static final Duration MARGIN = Duration.ofMillis(200);

  static final Duration PATIENCE = Duration.ofSeconds(30);

  final CountDownLatch blocked = new CountDownLatch(1);
  final CountDownLatch release = new CountDownLatch(1);
  final ExecutorService threads = Executors.newCachedThreadPool();
  final List<AutoCloseable> open = new ArrayList<>();
  final StallProbe probe = StallProbe.start();

  /** Where the server listens. */
  abstract ServerEndpoint endpoint();

  /** A server's endpoint on this computer, if only its port is known. */
  abstract Endpoint client(int port);

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

  Service export(long deadlineMillis) throws Exception {
    BasicJeriExporter exporter =
        new BasicJeriExporter(endpoint(), new DeadlineILFactory(deadlineMillis), false, true);
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
        .withMessageContaining("Service.block on 127.0.0.1:")
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

  static void assertNotRun(Service service) {
    assertThatExceptionOfType(DeadlineExceededException.class)
        .isThrownBy(() -> service.echo("x"))
        .satisfies(
            e -> {
              assertThat(e.mayHaveRun()).isFalse();
              assertThat(e.getMessage()).containsAnyOf("it has not run", "was not tried");
            });
  }

  Service proxy(int port, long deadlineMillis) {
    return proxy(client(port), deadlineMillis);
  }

  static Service proxy(Endpoint endpoint, long deadlineMillis) {
    return (Service)
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(endpoint, UuidFactory.generate(), false),
            Duration.ofMillis(deadlineMillis),
            DeadlineContract.class.getClassLoader(),
            Service.class,
            RemoteMethodControl.class);
  }

  static boolean works(Service service) {
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
