package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.BindException;
import java.net.UnknownHostException;
import net.jini.jeri.InboundRequest;
import net.jini.jeri.ServerEndpoint;
import org.junit.jupiter.api.Test;

class TcpTransportTest extends TransportContract {

  @Override
  boolean finishesCalls() {
    return true;
  }

  @Override
  ServerEndpoint serverEndpoint() {
    return new TransportServerEndpoint(HOST, 0);
  }

  @Test
  void aCallIsAnsweredThoughItIsAbortedAfterItsEnd() throws IOException {
    assertAnsweredThoughInterruptedAndAborted();
  }

  @Test
  void anAddressOfAnotherComputerAndATakenPortAreNamed() throws IOException {
    assertThatThrownBy(() -> listen("192.0.2.1", 0))
        .isInstanceOf(BindException.class)
        .hasMessageContaining("cannot listen on 192.0.2.1:0")
        .hasMessageEndingWith("name an address of this machine and a port that nobody uses");
    int taken = ((TransportEndpoint) endpoint).port();
    assertThatThrownBy(() -> listen(HOST, taken))
        .isInstanceOf(BindException.class)
        .hasMessageContaining("cannot listen on 127.0.0.1:" + taken);
  }

  @Test
  void anUnknownHostIsNamed() {
    assertThatThrownBy(() -> listen("no-such-host.invalid", 0))
        .isInstanceOf(UnknownHostException.class)
        .hasMessage("host no-such-host.invalid is not known; name an address of this machine");
  }

  private static void listen(String host, int port) throws IOException {
    Object unused =
        new TransportServerEndpoint(host, port)
            .enumerateListenEndpoints(
                each -> {
                  throw new AssertionError(
                      "it listens: " + each.listen(InboundRequest::abort).getCookie());
                });
  }
}
