package org.dfra.river.discovery;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import java.io.Serializable;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.rmi.MarshalledObject;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import net.jini.core.lookup.ServiceRegistrar;
import org.dfra.river.discovery.UnicastDiscovery.DiscoveryResponse;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A client that asks for a lookup service, and what may answer instead. */
@Timeout(60)
class UnicastDiscoveryTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final Duration BRIEF = Duration.ofMillis(300);

  private static final FakeRegistrar HONEST = new FakeRegistrar(7, "field");

  @Test
  void findsALookupServiceAndItsGroups() throws Exception {
    DiscoveryResponse answer = ask(AnsweringServer.answer(HONEST, List.of("field", "yard")));
    assertThat(answer.registrar().getServiceID()).isEqualTo(HONEST.getServiceID());
    assertThat(answer.groups()).containsExactly("field", "yard");
  }

  @Test
  void refusesAClaimOfManyGroups() throws Exception {
    byte[] bytes = AnsweringServer.answer(HONEST, List.of());
    for (int claimed : new int[] {Integer.MAX_VALUE, -1, UnicastDiscovery.GROUPS + 1}) {
      ByteArrayOutputStream forged = new ByteArrayOutputStream();
      try (ObjectOutputStream out = new ObjectOutputStream(forged)) {
        out.writeObject(new MarshalledObject<>(HONEST));
        out.writeInt(claimed);
      }
      assertThat(forged.size()).isEqualTo(bytes.length);
      refused(forged.toByteArray(), "groups");
    }
    String longest = "g".repeat(UnicastDiscovery.GROUP_CHARACTERS);
    assertThat(
            ask(AnsweringServer.answer(
                    HONEST, Collections.nCopies(UnicastDiscovery.GROUPS, longest)))
                .groups())
        .hasSize(UnicastDiscovery.GROUPS);
    refused(AnsweringServer.answer(HONEST, List.of(longest + "g")), "characters");
  }

  @Test
  void refusesAnArrayThatIsMerelyClaimed() throws Exception {
    byte[] array = serialized(new byte[1]);
    byte[] claim = Arrays.copyOf(array, array.length - 1);
    claim[claim.length - 4] = 0x40; // 1 GiB and one
    refused(claim, "REJECTED");
  }

  @Test
  void refusesWhatIsNoMarshalledObject() throws Exception {
    refused(serialized(new HashSet<>(List.of("a"))), "the answer contains class java.util.HashSet");
    refused(serialized("a"), "does not begin with a marshalled object");
    refused(serialized(new byte[1]), "does not begin with a marshalled object");
  }

  @Test
  void refusesProxiesThatAreNone() throws Exception {
    refused(AnsweringServer.answer("a", List.of()), "java.lang.String, not a lookup service");
    Object dynamic =
        Proxy.newProxyInstance(
            UnicastDiscoveryTest.class.getClassLoader(),
            new Class<?>[] {ServiceRegistrar.class},
            new Stalling());
    refused(AnsweringServer.answer(dynamic, List.of()), "not a lookup service");
  }

  @Test
  void refusesAProxyThatTakesForEverToBuild() throws Exception {
    List<Object> ladder = new ArrayList<>(List.of("x"));
    List<Object> rungs = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      rungs.add(ladder);
      ladder = new ArrayList<>(List.of(ladder, ladder));
    }
    List<Object> key = new ArrayList<>();
    HashSet<Object> set = new HashSet<>(List.of(key));
    key.add(ladder);
    Object[] bomb = {rungs.toArray(), set};
    refused(AnsweringServer.answer(bomb, List.of()), "steps to hash keys");
  }

  @Test
  void refusesAnAnswerWithoutEnd() throws Exception {
    byte[] chunk = new byte[1 << 16];
    Arrays.fill(chunk, (byte) 'a');
    byte[] head = {(byte) 0xAC, (byte) 0xED, 0, 5, 0x7C, 0x7F, 0, 0, 0, 0, 0, 0, 0}; // long string
    try (AnsweringServer server =
        new AnsweringServer(
            out -> {
              out.write(head);
              for (int i = 0; i < 10_000; i++) {
                out.write(chunk);
              }
            })) {
      assertThatThrownBy(() -> UnicastDiscovery.discover(server.host(), server.port(), PATIENCE))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("bytes allowed");
    }
  }

  @Test
  void refusesAnAnswerThatWasCut() throws Exception {
    byte[] whole = AnsweringServer.answer(HONEST, List.of("field"));
    for (int length : new int[] {0, 3, 4, 50, whole.length - 1}) {
      refused(Arrays.copyOf(whole, length), "no lookup service answers at");
    }
  }

  /** A read without a deadline does not notice an interruption either. */
  @Test
  @Timeout(value = 30, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void waitsForTheWholeAnswerOnlySoLong() throws Exception {
    CountDownLatch over = new CountDownLatch(1);
    byte[] whole = AnsweringServer.answer(HONEST, List.of("field"));
    try (AnsweringServer silent = new AnsweringServer(out -> await(over));
        AnsweringServer slow = new AnsweringServer(out -> drip(whole, out))) {
      for (AnsweringServer server : List.of(silent, slow)) {
        long began = System.nanoTime();
        assertThatThrownBy(() -> UnicastDiscovery.discover(server.host(), server.port(), BRIEF))
            .isInstanceOf(IOException.class);
        assertThat(Duration.ofNanos(System.nanoTime() - began)).isLessThan(Duration.ofSeconds(10));
      }
    } finally {
      over.countDown();
    }
  }

  /** The port is bound, so no other program can take it meanwhile, and refuses connections. */
  @Test
  void reportsThatNobodyListens() throws Exception {
    try (Socket reserved = new Socket()) {
      reserved.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
      String host = reserved.getLocalAddress().getHostAddress();
      assertThatThrownBy(() -> UnicastDiscovery.discover(host, reserved.getLocalPort(), PATIENCE))
          .isInstanceOf(ConnectException.class);
    }
  }

  private static DiscoveryResponse ask(byte[] answer) throws Exception {
    try (AnsweringServer server = new AnsweringServer(out -> out.write(answer))) {
      return UnicastDiscovery.discover(server.host(), server.port(), PATIENCE);
    }
  }

  private static void refused(byte[] answer, String why) {
    assertThatThrownBy(() -> ask(answer))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("no lookup service answers at")
        .hasMessageContaining(why);
  }

  private static byte[] serialized(Object object) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(object);
    }
    return bytes.toByteArray();
  }

  private static void await(CountDownLatch latch) throws IOException {
    try {
      latch.await();
    } catch (InterruptedException e) {
      throw new IOException(e);
    }
  }

  /** A byte now and then: a timeout that restarts with each byte would last half a minute. */
  private static void drip(byte[] bytes, OutputStream out) throws IOException {
    CountDownLatch never = new CountDownLatch(1);
    for (byte each : bytes) {
      out.write(each);
      out.flush();
      try {
        boolean unused = never.await(100, TimeUnit.MILLISECONDS);
      } catch (InterruptedException e) {
        throw new IOException(e);
      }
    }
  }

  /** Would never answer. */
  private static final class Stalling implements InvocationHandler, Serializable {
    private static final long serialVersionUID = 1L;

    @Override
    public Object invoke(Object proxy, Method method, @Nullable Object @Nullable [] args) {
      throw new AssertionError(method + " of a stranger's proxy was called");
    }
  }
}
