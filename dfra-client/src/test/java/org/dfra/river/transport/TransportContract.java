package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import net.jini.core.constraint.Confidentiality;
import net.jini.core.constraint.Integrity;
import net.jini.core.constraint.InvocationConstraint;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.io.UnsupportedConstraintException;
import net.jini.io.context.ClientHost;
import net.jini.jeri.Endpoint;
import net.jini.jeri.InboundRequest;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.OutboundRequestIterator;
import net.jini.jeri.RequestDispatcher;
import net.jini.jeri.ServerEndpoint;
import net.jini.jeri.ServerEndpoint.ListenCookie;
import net.jini.jeri.ServerEndpoint.ListenEndpoint;
import net.jini.jeri.ServerEndpoint.ListenHandle;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * What JERI expects of a transport, and River's own one fulfils too: requests and responses of any
 * size arrive complete and in order, each only once, and every failure says whether the request may
 * have been delivered.
 */
@Timeout(60)
abstract class TransportContract {

  static final String HOST = "127.0.0.1";
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final List<ListenHandle> handles = new ArrayList<>();
  private final ExecutorService callers = Executors.newCachedThreadPool();
  private final AtomicInteger dispatched = new AtomicInteger();
  private final ConcurrentLinkedQueue<Object> contexts = new ConcurrentLinkedQueue<>();
  private volatile RequestDispatcher dispatcher = this::echo;
  Endpoint endpoint;

  abstract ServerEndpoint serverEndpoint();

  /** A constraint that no connection of this transport meets. */
  InvocationConstraint unmetConstraint() {
    return Confidentiality.YES;
  }

  /** The integrity that connections of this transport have. */
  Integrity integrity() {
    return Integrity.NO;
  }

  @BeforeEach
  void listen() throws IOException {
    endpoint =
        serverEndpoint()
            .enumerateListenEndpoints(
                each -> {
                  ListenHandle handle = listen(each);
                  handles.add(handle);
                  return handle.getCookie();
                });
  }

  private ListenHandle listen(ListenEndpoint each) throws IOException {
    each.checkPermissions();
    return each.listen(request -> dispatcher.dispatch(request));
  }

  @AfterEach
  void close() {
    callers.shutdownNow();
    handles.forEach(ListenHandle::close);
  }

  /** Answers with the bytes of the request. */
  private void echo(InboundRequest request) {
    dispatched.incrementAndGet();
    try (InputStream in = request.getRequestInputStream();
        OutputStream out = request.getResponseOutputStream()) {
      byte[] bytes = in.readAllBytes();
      out.write(bytes);
    } catch (IOException e) {
      request.abort();
    }
  }

  /** Holds each request until it may go on. */
  private static RequestDispatcher holding(
      CountDownLatch arrived, CountDownLatch goOn, RequestDispatcher then) {
    return request -> {
      arrived.countDown();
      try {
        goOn.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      then.dispatch(request);
    };
  }

  /** A request with these bytes. */
  OutboundRequest send(byte[] bytes) throws IOException {
    OutboundRequest request = next();
    try (OutputStream out = request.getRequestOutputStream()) {
      out.write(bytes);
    }
    return request;
  }

  OutboundRequest next() throws IOException {
    OutboundRequestIterator attempts = endpoint.newRequest(InvocationConstraints.EMPTY);
    assertThat(attempts.hasNext()).isTrue();
    return attempts.next();
  }

  byte[] call(byte[] bytes) throws IOException {
    OutboundRequest request = send(bytes);
    try (InputStream in = request.getResponseInputStream()) {
      return in.readAllBytes();
    }
  }

  @Test
  void messagesOfEverySizeArriveComplete() throws IOException {
    Random random = new Random(17);
    for (int size :
        new int[] {
          0, 1, 100, 4095, 8191, 8192, 16379, 16380, 16381, 16384, 32760, 65537, 1_000_003
        }) {
      byte[] bytes = new byte[size];
      random.nextBytes(bytes);
      assertThat(call(bytes)).as(size + " bytes").isEqualTo(bytes);
    }
  }

  @Test
  void singleBytesAndNumbersArriveInOrder() throws IOException {
    OutboundRequest request = next();
    try (DataOutputStream out = new DataOutputStream(request.getRequestOutputStream())) {
      for (int i = 0; i < 20_000; i++) {
        out.writeInt(i);
      }
    }
    try (DataInputStream in = new DataInputStream(request.getResponseInputStream())) {
      for (int i = 0; i < 20_000; i++) {
        assertThat(in.readInt()).isEqualTo(i);
      }
      assertThat(in.read()).isEqualTo(-1);
      assertThat(in.read()).as("again").isEqualTo(-1);
    }
  }

  @Test
  void manyCallersGetTheirOwnResponses() throws Exception {
    List<Future<Boolean>> results = new ArrayList<>();
    for (int i = 0; i < 32; i++) {
      byte id = (byte) i;
      results.add(
          callers.submit(
              () -> {
                byte[] bytes = {id, 1, 2, 3};
                for (int n = 0; n < 200; n++) {
                  assertThat(call(bytes)).isEqualTo(bytes);
                }
                return true;
              }));
    }
    for (Future<Boolean> each : results) {
      assertThat(each.get(30, TimeUnit.SECONDS)).isTrue();
    }
    assertThat(dispatched).hasValue(32 * 200);
  }

  @Test
  void theServerKnowsTheClientsHost() throws IOException {
    dispatcher =
        request -> {
          Collection<Object> context = new ArrayList<>();
          request.populateContext(context);
          contexts.addAll(context);
          echo(request);
        };
    byte[] unused = call(new byte[1]);
    InetAddress host = InetAddress.getByName(HOST);
    assertThat(contexts)
        .anySatisfy(
            each ->
                assertThat(each)
                    .isInstanceOfSatisfying(
                        ClientHost.class, it -> assertThat(it.getClientHost()).isEqualTo(host)));
  }

  @Test
  void aServerMayAnswerBeforeItHasReadTheRequest() throws IOException {
    dispatcher =
        request -> {
          try (OutputStream out = request.getResponseOutputStream()) {
            out.write(7);
          } catch (IOException e) {
            request.abort();
          }
        };
    for (int size : new int[] {10, 20_000, 3_000_000}) {
      assertThat(call(new byte[size])).as("to " + size + " bytes").containsExactly(7);
    }
    dispatcher = this::echo;
    assertThat(call(new byte[] {1, 2})).as("the next call").containsExactly(1, 2);
  }

  @Test
  void aCallerMayCloseTheResponseBeforeItsEnd() throws IOException {
    for (int size : new int[] {100, 200_000}) {
      OutboundRequest request = send(new byte[size]);
      InputStream in = request.getResponseInputStream();
      assertThat(in.read()).isZero();
      in.close();
      assertThat(call(new byte[] {5})).as("the next call").containsExactly(5);
    }
  }

  @Test
  void anAbortedRequestSaysWhetherItMayHaveArrived() throws Exception {
    OutboundRequest unsent = next();
    unsent.abort();
    assertThat(unsent.getDeliveryStatus()).as("nothing was written").isFalse();

    CountDownLatch arrived = new CountDownLatch(1);
    CountDownLatch goOn = new CountDownLatch(1);
    dispatcher = holding(arrived, goOn, InboundRequest::abort);
    OutboundRequest sent = send(new byte[3]);
    arrived.await();
    Future<?> reading =
        callers.submit(
            () ->
                assertThatExceptionOfType(IOException.class)
                    .isThrownBy(() -> sent.getResponseInputStream().read()));
    sent.abort();
    reading.get(30, TimeUnit.SECONDS);
    assertThat(sent.getDeliveryStatus()).isTrue();
    goOn.countDown();
  }

  /**
   * As River does with the calls of an object that is unexported by force in the moment in which
   * they end. Other calls use the connection.
   */
  void assertAnsweredThoughInterruptedAndAborted() throws IOException {
    dispatcher =
        request -> {
          Thread.currentThread().interrupt();
          echo(request);
          Thread.currentThread().interrupt();
          request.abort();
        };
    for (int i = 0; i < 3; i++) {
      OutboundRequest request = send(new byte[] {1, 2, 3});
      try (InputStream in = request.getResponseInputStream()) {
        assertThat(in.readAllBytes()).as("call " + i).containsExactly(1, 2, 3);
      }
    }
    dispatcher = this::echo;
    assertThat(call(new byte[] {4})).as("of another object").containsExactly(4);
  }

  @Test
  void aServerThatAbortsEndsTheCall() {
    dispatcher = InboundRequest::abort;
    assertThatThrownBy(() -> call(new byte[10])).isInstanceOf(IOException.class);
    dispatcher = this::echo;
    await().atMost(PATIENCE).untilAsserted(() -> assertThat(call(new byte[1])).hasSize(1));
  }

  @Test
  void aDispatcherThatFailsEndsOnlyItsCall() throws IOException {
    dispatcher =
        request -> {
          throw new IllegalStateException("thrown by a test, to be logged");
        };
    assertThatThrownBy(() -> call(new byte[10])).isInstanceOf(IOException.class);
    dispatcher = this::echo;
    assertThat(call(new byte[1])).hasSize(1);
  }

  @Test
  void aConstraintThatCannotBeMetIsRefused() {
    InvocationConstraints unmet =
        new InvocationConstraints(new InvocationConstraint[] {unmetConstraint()}, null);
    assertThatThrownBy(() -> endpoint.newRequest(unmet).next())
        .isInstanceOf(UnsupportedConstraintException.class);
    assertThatThrownBy(() -> serverEndpoint().checkConstraints(unmet))
        .isInstanceOf(UnsupportedConstraintException.class);
  }

  @Test
  void integrityRemainsForTheLayerAbove() throws Exception {
    InvocationConstraints none =
        new InvocationConstraints(new InvocationConstraint[] {integrity()}, null);
    OutboundRequest request = endpoint.newRequest(none).next();
    assertThat(request.getUnfulfilledConstraints().requirements()).containsExactly(integrity());
    request.abort();
  }

  @Test
  void nobodyIsServedAfterThePortIsClosed() throws IOException {
    assertThat(call(new byte[1])).hasSize(1);
    handles.forEach(ListenHandle::close);
    assertThatThrownBy(() -> call(new byte[1])).isInstanceOf(IOException.class);
    assertThat(dispatched).hasValue(1);
  }

  /** Whether calls in progress are answered after the port was closed. */
  abstract boolean finishesCalls();

  @Test
  void aCallInProgressMayBeAnsweredAfterThePortIsClosed() throws Exception {
    CountDownLatch arrived = new CountDownLatch(1);
    CountDownLatch goOn = new CountDownLatch(1);
    dispatcher = holding(arrived, goOn, this::echo);
    Future<byte[]> answer = callers.submit(() -> call(new byte[] {9}));
    arrived.await();
    closePorts();
    goOn.countDown();
    if (finishesCalls()) {
      assertThat(answer.get(30, TimeUnit.SECONDS)).containsExactly(9);
    } else {
      assertThatThrownBy(() -> answer.get(30, TimeUnit.SECONDS))
          .hasCauseInstanceOf(IOException.class);
    }
  }

  /** As JERI does when the last object on a port is no longer exported. */
  void closePorts() {
    handles.forEach(ListenHandle::close);
  }

  @Test
  void aCookieOfAnotherEndpointIsRefused() {
    assertThatThrownBy(
            () -> serverEndpoint().enumerateListenEndpoints(each -> new ListenCookie() {}))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
