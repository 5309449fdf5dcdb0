package org.dfra.core.host;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;

class FreePortsTest {

  @Test
  void givesEachPortOnceAndOneThatCanBeOpened() throws Exception {
    Set<Integer> given = new HashSet<>();
    for (int count = 0; count < 50; count++) {
      int port = FreePorts.allocate();
      assertThat(given.add(port)).as("port %d is new", port).isTrue();
      try (ServerSocket socket = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
        assertThat(socket.getLocalPort()).isEqualTo(port);
      }
    }
  }

  @Test
  void staysBelowThePortsOfOutgoingConnections() throws Exception {
    Path range = Path.of("/proc/sys/net/ipv4/ip_local_port_range");
    Assumptions.assumeTrue(
        Files.isReadable(range), "this host does not tell the ports of its outgoing connections");
    int least = Integer.parseInt(Files.readAllLines(range).get(0).strip().split("\\s+")[0]);
    Assumptions.assumeTrue(
        least >= FreePorts.END, "this host takes its outgoing ports from " + least + " on");
    assertThat(FreePorts.allocate())
        .isBetween(FreePorts.FIRST, FreePorts.END - 1)
        .isLessThan(least);
  }
}
