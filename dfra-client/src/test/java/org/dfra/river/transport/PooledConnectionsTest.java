package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.ConnectException;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.jeri.InboundRequest;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.OutboundRequestIterator;
import net.jini.jeri.ServerEndpoint.ListenHandle;
import org.dfra.river.transport.ConnectionLimits.Resource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Connections are used again, and one that the server has closed costs no call. */
@Timeout(60)
class PooledConnectionsTest {

  private static final String HOST = "127.0.0.1";
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final AtomicInteger executed = new AtomicInteger();
  private ListenHandle handle;

  private TransportEndpoint listen(int port) throws IOException {
    return (TransportEndpoint)
        new TransportServerEndpoint(HOST, port)
            .enumerateListenEndpoints(
                each -> {
                  handle = each.listen(this::echo);
                  return handle.getCookie();
                });
  }

  @AfterEach
  void close() {
    handle.close();
  }

  private void echo(InboundRequest request) {
    executed.incrementAndGet();
    try (InputStream in = request.getRequestInputStream();
        OutputStream out = request.getResponseOutputStream()) {
      out.write(in.readAllBytes());
    } catch (IOException e) {
      request.abort();
    }
  }

  /** As JERI's invocation handlers do: once more if the request was certainly not delivered. */
  private static byte[] call(TransportEndpoint endpoint, byte... bytes) throws IOException {
    OutboundRequestIterator attempts = endpoint.newRequest(InvocationConstraints.EMPTY);
    while (true) {
      OutboundRequest request = attempts.next();
      try {
        try (OutputStream out = request.getRequestOutputStream()) {
          out.write(bytes);
        }
        try (InputStream in = request.getResponseInputStream()) {
          return in.readAllBytes();
        }
      } catch (IOException e) {
        request.abort();
        if (request.getDeliveryStatus() || !attempts.hasNext()) {
          throw e;
        }
      }
    }
  }

  private static int connections() {
    return ConnectionSelector.instance().limits().total(Resource.CONNECTIONS);
  }

  @Test
  void callsOneAfterAnotherUseOneConnection() throws IOException {
    TransportEndpoint endpoint = listen(0);
    int before = connections();
    for (int i = 0; i < 1000; i++) {
      assertThat(call(endpoint, (byte) i)).containsExactly((byte) i);
    }
    assertThat(connections() - before).isLessThanOrEqualTo(1); // others may end meanwhile
  }

  /** As JERI leaves a response that says that there is no such object. */
  @Test
  void aResponseThatWasReadButNotClosedLeavesItsConnection() throws IOException {
    TransportEndpoint endpoint = listen(0);
    int before = connections();
    for (int i = 0; i < 100; i++) {
      OutboundRequest request = endpoint.newRequest(InvocationConstraints.EMPTY).next();
      try (OutputStream out = request.getRequestOutputStream()) {
        out.write(i);
      }
      assertThat(request.getResponseInputStream().read()).isEqualTo(i);
      request.abort();
    }
    assertThat(connections() - before).isLessThanOrEqualTo(1);
    assertThat(call(endpoint, (byte) 7)).containsExactly(7);
  }

  @Test
  void theServersThreadIsFreeAfterThePause() throws IOException {
    TransportEndpoint endpoint = listen(0);
    assertThat(call(endpoint, (byte) 1)).hasSize(1);
    await("no worker waits")
        .atMost(PATIENCE)
        .until(
            () ->
                ConnectionSelector.instance().limits().total(Resource.WAITING_WORKERS) == 0
                    && ConnectionSelector.instance().limits().total(Resource.WORKERS) == 0);
    int before = connections();
    assertThat(call(endpoint, (byte) 2)).containsExactly(2);
    assertThat(connections()).as("no new connection").isLessThanOrEqualTo(before);
  }

  @Test
  void aServerThatWasRestartedAtItsPortIsCalledAtOnce() throws IOException {
    TransportEndpoint endpoint = listen(0);
    for (int restart = 0; restart < 20; restart++) {
      assertThat(call(endpoint, (byte) restart)).containsExactly((byte) restart);
      handle.close();
      TransportEndpoint again = listen(endpoint.port());
      assertThat(again).isEqualTo(endpoint);
      assertThat(call(endpoint, (byte) 1, (byte) restart)).containsExactly(1, restart);
    }
    assertThat(executed).as("each call once").hasValue(40);
  }

  @Test
  void aServerThatHasEndedIsReportedAsRefusing() throws IOException {
    TransportEndpoint endpoint = listen(0);
    assertThat(call(endpoint, (byte) 1)).hasSize(1);
    handle.close();
    assertThatThrownBy(() -> call(endpoint, (byte) 2)).isInstanceOf(ConnectException.class);
    assertThat(executed).hasValue(1);
  }

  @Test
  void idleConnectionsAreClosedOnDemand() throws IOException {
    TransportEndpoint endpoint = listen(0);
    int before = connections();
    assertThat(call(endpoint, (byte) 1)).hasSize(1);
    endpoint.closeIdleConnections();
    await().atMost(PATIENCE).until(() -> connections() <= before);
    assertThat(call(endpoint, (byte) 2)).containsExactly(2);
  }
}
