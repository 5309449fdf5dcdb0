package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Whose process listens on a port. */
class PortOwnerTest {

  /** Ports 0x04AE, 1198, and 0x04AF, 1199; states 0A, listening, and 01, connected. */
  private static final String TCP =
      """
        sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode
         0: 0100007F:04AE 00000000:0000 0A 00000000:00000000 00:00000000 00000000  1000        0 1
         1: 0200007F:04AE 00000000:0000 0A 00000000:00000000 00:00000000 00000000  1001        0 2
         2: 00000000:04AF 00000000:0000 0A 00000000:00000000 00:00000000 00000000 65534        0 3
         3: 0300007F:04AE 0100007F:9999 01 00000000:00000000 00:00000000 00000000  1003        0 4
      """;

  private static final String TCP6 =
      """
        sl  local_address                         remote_address                        st tx_queue
         0: 0000000000000000FFFF00000400007F:04AE 00000000000000000000000000000000:0000 0A 0:0 0:0 0 1004 0 5
         1: 00000000000000000000000000000000:04B0 00000000000000000000000000000000:0000 0A 0:0 0:0 0 1005 0 6
      """;

  @TempDir Path proc;
  private PortOwner owners;

  @BeforeEach
  void table() throws Exception {
    Files.createDirectory(proc.resolve("net"));
    Files.writeString(proc.resolve("net/tcp"), TCP);
    Path users = Files.writeString(proc.resolve("passwd"), "root:x:0:0::/root:/bin/sh\na:x:1000:1");
    owners = new PortOwner(proc, users);
  }

  @Test
  void listenersAreDistinguishedByAddressAndPort() throws Exception {
    Files.writeString(proc.resolve("net/tcp6"), TCP6);
    assertThat(owners.uidOf("127.0.0.1", 1198)).hasValue(1000);
    assertThat(owners.uidOf("127.0.0.2", 1198)).hasValue(1001);
    assertThat(owners.uidOf("127.0.0.9", 1199)).as("at all addresses").hasValue(65534);
    assertThat(owners.uidOf("127.0.0.3", 1198)).as("a connection").isEmpty();
    assertThat(owners.uidOf("127.0.0.4", 1198)).as("IPv4 in IPv6").hasValue(1004);
    assertThat(owners.uidOf("127.0.0.9", 1200)).as("at all addresses of IPv6").hasValue(1005);
    assertThat(owners.uidOf("127.0.0.1", 1201)).isEmpty();
  }

  @Test
  void withoutATableNothingIsKnown() {
    assertThat(new PortOwner(proc.resolve("none"), proc).uidOf("127.0.0.1", 1198)).isEmpty();
    assertThat(new PortOwner(proc, proc.resolve("none")).userName(7)).isEqualTo("7");
  }

  @Test
  void usersHaveNamesWhereTheyAreListed() {
    assertThat(owners.userName(1000)).isEqualTo("a");
    assertThat(owners.userName(1001)).isEqualTo("1001");
  }

  @Test
  void thisUsersListenerIsFound() throws Exception {
    assumeTrue(Files.exists(Path.of("/proc/net/tcp")), "only Linux tells who listens");
    int own = (Integer) Files.getAttribute(Path.of("/proc/self"), "unix:uid");
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
      assertThat(PortOwner.system().uidOf("127.0.0.1", socket.getLocalPort())).hasValue(own);
    }
  }
}
