package org.dfra.river.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.NotSerializableException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.Activator;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import javax.net.SocketFactory;
import net.jini.export.Exporter;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.BasicInvocationHandler;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.tcp.TcpEndpoint;
import net.jini.jeri.tcp.TcpServerEndpoint;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Whatever a peer's proxy brings, a call on it ends when this computer says so. */
@Timeout(60)
class CallbackProxiesTest {

  /** What is called back here. */
  public interface Service extends Remote {
    String echo(String text) throws RemoteException;

    void block() throws RemoteException;
  }

  private static final String HOST = "127.0.0.1";
  private static final Duration DEADLINE = Duration.ofMillis(200);

  /** After a deadline, for the timer, the threads, and classes that are needed the first time. */
  private static final Duration MARGIN = Duration.ofMillis(300);

  private final CountDownLatch release = new CountDownLatch(1);
  private final List<AutoCloseable> open = new ArrayList<>();
  private final Server server = new Server(); // JERI holds it only weakly
  private final StallProbe probe = StallProbe.start();

  private final class Server implements Service {
    @Override
    public String echo(String text) {
      return text;
    }

    @Override
    public void block() {
      try {
        release.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  @AfterEach
  void end() throws Exception {
    probe.close();
    release.countDown();
    for (AutoCloseable each : open) {
      each.close();
    }
  }

  /** As stock peers export: no deadline, no sockets of DFRA's. */
  private Service stock() throws Exception {
    Exporter exporter =
        new BasicJeriExporter(
            TcpServerEndpoint.getInstance(HOST, 0, null, Endpoints.serverSocketFactory(HOST)),
            new BasicILFactory(),
            false,
            false);
    open.add(() -> exporter.unexport(true));
    return (Service) exporter.export(server);
  }

  private static Service bounded(Service callback) {
    return CallbackProxies.withDeadline(callback, Service.class, DEADLINE);
  }

  private Timing timeExceeded(Service callback) {
    StallProbe.Stopwatch began = probe.stopwatch();
    assertThatExceptionOfType(DeadlineExceededException.class)
        .isThrownBy(callback::block)
        .withMessageContaining("Service.block on " + HOST)
        .withMessageContaining("got no answer within 200 ms");
    return began.stop();
  }

  @Test
  void aStockProxyIsCalledUnderOurDeadline() throws Exception {
    Service callback = bounded(stock());
    assertThat(callback.echo("hello")).isEqualTo("hello");
    Timing ended = timeExceeded(callback);
    assertThat(ended.took()).isGreaterThan(DEADLINE.minusMillis(10));
    assertThat(callback.echo("again")).isEqualTo("again");
    ended.requireWithin("a callback with a deadline of 200 ms", DEADLINE.plus(MARGIN));
  }

  @Test
  void theDeadlineThatAProxyBringsDoesNotCount() throws Exception {
    Exporter exporter =
        new BasicJeriExporter(
            Endpoints.tcp(HOST, 0),
            new DeadlineILFactory(Duration.ofHours(3).toMillis()),
            false,
            false);
    open.add(() -> exporter.unexport(true));
    Service callback = bounded((Service) exporter.export(server));
    assertThat(callback.echo("hello")).isEqualTo("hello");
    timeExceeded(callback).requireWithin("a callback of 200 ms", DEADLINE.plus(MARGIN));
  }

  @Test
  void theCallRunsOnTheCallersThreadAndStartsNone() throws Exception {
    Service callback = bounded(stock());
    assertThat(callback.echo("warm")).isEqualTo("warm");
    FutureTask<Timing> hanging = new FutureTask<>(() -> timeExceeded(callback));
    Thread caller = new Thread(hanging, "one callback");
    long before = threads("dfra-call-");
    caller.start();
    Timing unused = hanging.get(30, TimeUnit.SECONDS);
    assertThat(threads("dfra-call-"))
        .as("threads that wait for answers")
        .isLessThanOrEqualTo(before);
  }

  private static long threads(String prefix) {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().startsWith(prefix))
        .count();
  }

  @Test
  void aPeerThatTakesTheConnectionAndSaysNothingLosesIt() throws Exception {
    try (ServerSocket mute = new ServerSocket(0, 50, InetAddress.getByName(HOST))) {
      Service callback = bounded(proxy(TcpEndpoint.getInstance(HOST, mute.getLocalPort())));
      FutureTask<Timing> call = new FutureTask<>(() -> timeExceeded(callback));
      new Thread(call, "callback of a mute peer").start();
      try (Socket taken = mute.accept()) {
        taken.setSoTimeout(30_000);
        assertThat(taken.getInputStream().readAllBytes())
            .as("what came before this computer closed the connection")
            .isNotEmpty();
        Timing ended = call.get(30, TimeUnit.SECONDS);
        ended.requireWithin(
            "a callback with a deadline of 200 ms, and a probe", DEADLINE.plus(MARGIN));
      }
    }
  }

  @Test
  void theSocketFactoryThatAProxyBringsIsNotUsed() throws Exception {
    BasicInvocationHandler handler = (BasicInvocationHandler) Proxy.getInvocationHandler(stock());
    BasicObjectEndpoint object = (BasicObjectEndpoint) handler.getObjectEndpoint();
    TcpEndpoint tcp = (TcpEndpoint) object.getEndpoint();
    TcpEndpoint hostile = TcpEndpoint.getInstance(tcp.getHost(), tcp.getPort(), new NoSockets());
    Service callback = bounded(proxy(hostile, object.getObjectIdentifier()));
    assertThat(callback.echo("hello")).isEqualTo("hello");
  }

  /** Sockets as a hostile peer would send them: what uses them fails. */
  private static final class NoSockets extends SocketFactory {
    @Override
    public Socket createSocket() {
      throw new AssertionError("the peer's sockets are used");
    }

    @Override
    public Socket createSocket(String host, int port) {
      return createSocket();
    }

    @Override
    public Socket createSocket(InetAddress host, int port) {
      return createSocket();
    }

    @Override
    public Socket createSocket(String host, int port, InetAddress from, int fromPort) {
      return createSocket();
    }

    @Override
    public Socket createSocket(InetAddress host, int port, InetAddress from, int fromPort) {
      return createSocket();
    }
  }

  @Test
  void whereAProxyPointsIsItsProcess() {
    Object first = CallbackProxies.processKey(proxy(TcpEndpoint.getInstance(HOST, 7001)));
    assertThat(
            CallbackProxies.processKey(proxy(TcpEndpoint.getInstance(HOST, 7001, new NoSockets()))))
        .as("the same place with another identity and other sockets")
        .isEqualTo(first);
    assertThat(CallbackProxies.processKey(proxy(TcpEndpoint.getInstance(HOST, 7002))))
        .isNotEqualTo(first);
  }

  @Test
  void whatCallsBackIsNeverSent() throws Exception {
    Service callback = bounded(stock());
    try (ObjectOutputStream out = new ObjectOutputStream(OutputStream.nullOutputStream())) {
      assertThatExceptionOfType(NotSerializableException.class)
          .isThrownBy(() -> out.writeObject(callback));
    }
  }

  @Test
  void aDeadlineOfHoursIsShortenedWhenItIsRead() throws Exception {
    Object sent =
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(Endpoints.tcpClient(HOST, 7001), UuidFactory.generate(), false),
            Duration.ofHours(3),
            CallbackProxiesTest.class.getClassLoader(),
            Service.class);
    DeadlineInvocationHandler own = (DeadlineInvocationHandler) Proxy.getInvocationHandler(sent);
    DeadlineInvocationHandler read =
        (DeadlineInvocationHandler) Proxy.getInvocationHandler(copy(sent));
    assertThat(own.deadlineMillis(Service.class.getMethod("block")))
        .as("what this computer made is not shortened")
        .isEqualTo(Duration.ofHours(3).toMillis());
    assertThat(read.deadlineMillis(Service.class.getMethod("block"))).isEqualTo(10_000);
    assertThat(read.deadlineMillis(activate()))
        .as("the start of a virtual machine")
        .isEqualTo(30_000);
    assertThat(new DeadlineInvocationHandler(read, null).deadlineMillis(activate()))
        .as("under other constraints")
        .isEqualTo(30_000);
  }

  private static Method activate() {
    return Arrays.stream(Activator.class.getMethods()).findFirst().orElseThrow();
  }

  private static Object copy(Object object) throws IOException, ClassNotFoundException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(object);
    }
    return new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray())).readObject();
  }

  private static Service proxy(TcpEndpoint endpoint) {
    return proxy(endpoint, UuidFactory.generate());
  }

  private static Service proxy(TcpEndpoint endpoint, Uuid id) {
    return (Service)
        Proxy.newProxyInstance(
            Service.class.getClassLoader(),
            new Class<?>[] {Service.class},
            new BasicInvocationHandler(new BasicObjectEndpoint(endpoint, id, false), null));
  }
}
