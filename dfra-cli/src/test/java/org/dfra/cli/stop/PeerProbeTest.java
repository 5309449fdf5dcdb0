package org.dfra.cli.stop;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Which peers answer connection attempts. */
@Timeout(60)
class PeerProbeTest {

  private static InetSocketAddress address(ServerSocket socket) {
    return new InetSocketAddress(socket.getInetAddress(), socket.getLocalPort());
  }

  @Test
  void peersThatAcceptOrRefuseAnswerAndOneThatIsUnreachableDoesNot() throws Exception {
    InetSocketAddress refusing;
    try (ServerSocket closed = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      refusing = address(closed);
    }
    try (PeerProbe probe = PeerProbe.start();
        UnreachablePeer unreachable = UnreachablePeer.open("127.0.7.99");
        ServerSocket accepting = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      CompletableFuture<Void> never = probe.answered(address(unreachable.server()));
      probe.answered(address(accepting)).get(20, TimeUnit.SECONDS);
      probe.answered(refusing).get(20, TimeUnit.SECONDS);
      assertThat(never).isNotDone();
      assertThat(probe.answered(address(accepting))).as("it was asked before").isDone();
    }
  }
}
