package org.dfra.attack.answer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.rmi.Remote;
import java.rmi.registry.LocateRegistry;
import java.rmi.server.RemoteObject;
import java.rmi.server.RemoteObjectInvocationHandler;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import org.dfra.benchmarks.attack.RawCall.Answer;
import org.dfra.benchmarks.attack.RawCall.Status;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** References of plain RMI in an argument: to read one starts a thread, which connects to it. */
@Timeout(120)
class JrmpReferenceTest {

  /** For what must not happen, in milliseconds. */
  private static final int BRIEF = 300;

  private static final int PATIENCE = 20_000;
  private static final String THREAD = "RMI RenewClean-";

  private OpenBox box;
  private ServerSocket attacker;

  @BeforeEach
  void export() throws Exception {
    box = new OpenBox();
    attacker = new ServerSocket(0, 50, InetAddress.getByName("127.0.0.1"));
  }

  @AfterEach
  void end() throws Exception {
    attacker.close();
    box.close();
  }

  @Test
  void areRefusedWithoutThreadOrConnection() throws Exception {
    List<Object> references =
        List.of(
            handler(),
            Proxy.newProxyInstance(
                Remote.class.getClassLoader(), new Class<?>[] {Remote.class}, handler()),
            new Object[] {"beside", handler()});
    for (Object reference : references) {
      Answer answer = box.send(box.call(reference));
      assertThat(answer.status()).as("%s", answer.failure()).isEqualTo(Status.THREW);
      assertThat((Throwable) answer.object())
          .hasStackTraceContaining("refused to read class java.rmi.server.RemoteObject")
          .hasStackTraceContaining("exported by JRMP");
    }
    attacker.setSoTimeout(BRIEF);
    assertThatThrownBy(attacker::accept).isInstanceOf(SocketTimeoutException.class);
    assertThat(collectors()).isZero();
    assertThat(box.proxy().put("still serving")).isEqualTo(1);
  }

  /** What the refusal prevents: that the test above would see it. */
  @Test
  void connectToTheAttackerWhereNothingIsFiltered() throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(handler());
    }
    attacker.setSoTimeout(PATIENCE);
    FutureTask<Object> reading =
        new FutureTask<>(
            () ->
                new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray())).readObject());
    Thread reader = new Thread(reading, "reads a JRMP reference");
    reader.setDaemon(true);
    reader.start(); // it waits for the attacker's answer
    try (Socket connection = attacker.accept()) {
      assertThat(connection.getPort()).isPositive();
      await().atMost(Duration.ofMillis(PATIENCE)).until(() -> collectors() > 0);
    }
    assertThat(reading.get(PATIENCE, TimeUnit.MILLISECONDS)).isInstanceOf(RemoteObject.class);
  }

  private RemoteObjectInvocationHandler handler() throws Exception {
    Remote registry = LocateRegistry.getRegistry("127.0.0.1", attacker.getLocalPort());
    return new RemoteObjectInvocationHandler(((RemoteObject) registry).getRef());
  }

  /** Threads that RMI keeps for references to this test's attacker. */
  private long collectors() {
    String end = ":" + attacker.getLocalPort() + "]";
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(name -> name.startsWith(THREAD) && name.contains(end))
        .count();
  }
}
