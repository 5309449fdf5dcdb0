package org.dfra.cli.doctor;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dfra.cli.doctor.Finding.Verdict;
import org.dfra.cli.doctor.PortCheck.PortUser;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is found of multicast and ports. */
class NetworkChecksTest {

  private static final List<String> FIELD = List.of("field");

  @TempDir Path folder;

  /** A network with one interface. */
  private interface OneInterface extends MulticastCheck.Network {
    @Override
    default List<String> interfaces() throws IOException {
      return List.of("eth0");
    }
  }

  @Test
  void whatIsSentByMulticastIsToBeReceived() {
    OneInterface good = there -> Optional.of(Duration.ofMillis(12));
    assertThat(new MulticastCheck(good, FIELD).run())
        .containsExactly(
            Finding.ok(Subject.MULTICAST, "a request on eth0 was received after 12 ms"));
    OneInterface firewall = there -> Optional.empty();
    assertThat(new MulticastCheck(firewall, FIELD).run())
        .singleElement()
        .returns(Verdict.FAIL, Finding::verdict)
        .satisfies(finding -> assertThat(finding.remedy()).contains("firewall", "UDP port 4160"));
    OneInterface noRoute =
        there -> {
          throw new IOException("Network is unreachable");
        };
    assertThat(new MulticastCheck(noRoute, FIELD).run())
        .singleElement()
        .returns(Verdict.FAIL, Finding::verdict)
        .returns("nothing can be sent on eth0 (Network is unreachable)", Finding::what);
  }

  @Test
  void multicastIsNoMatterWhereNobodyAsksForIt() {
    OneInterface firewall = there -> Optional.empty();
    assertThat(new MulticastCheck(firewall, List.of()).run())
        .containsExactly(
            Finding.ok(Subject.MULTICAST, "no group is asked for, so it is not needed"));
  }

  @Test
  void aComputerWithTheLoopbackAloneIsWarned() {
    MulticastCheck.Network alone =
        new MulticastCheck.Network() {
          @Override
          public List<String> interfaces() {
            return List.of();
          }

          @Override
          public Optional<Duration> roundTrip(String networkInterface) {
            throw new AssertionError("there is no " + networkInterface);
          }
        };
    assertThat(new MulticastCheck(alone, FIELD).run())
        .singleElement()
        .returns(Verdict.WARN, Finding::verdict);
  }

  @Test
  void aPortIsFreeOrOursOrSomebodyElses() {
    Map<Integer, PortUser> held =
        Map.of(
            1198, new PortUser(17, "java org.dfra.river.phoenix.Phoenix", true),
            1098, new PortUser(18, "rmiregistry", false),
            8085, new PortUser(-1, "", false));
    PortCheck.PortProbe ports = port -> Optional.ofNullable(held.get(port));
    assertThat(at(ports, 1198))
        .isEqualTo(Finding.ok(Subject.PORT, "1198, for a test, is held by DFRA, process 17"));
    assertThat(at(ports, 4160)).isEqualTo(Finding.ok(Subject.PORT, "4160, for a test, is free"));
    assertThat(at(ports, 1098))
        .isEqualTo(
            Finding.warn(
                Subject.PORT,
                "1098, for a test, is held by process 18, rmiregistry",
                "End it if it is not needed, or give a test another port."));
    assertThat(at(ports, 8085).what())
        .isEqualTo("8085, for a test, is held by a process of another user");
  }

  private static Finding at(PortCheck.PortProbe ports, int port) {
    return new PortCheck(ports, Map.of(port, "a test")).run().get(0);
  }

  @Test
  void linuxShowsWhichProcessListens() throws IOException {
    Path proc = folder;
    Files.createDirectories(proc.resolve("net"));
    Files.writeString(
        proc.resolve("net/tcp"),
        """
          sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode
           0: 0100007F:04AE 00000000:0000 0A 00000000:00000000 00:00000000 00000000     0        0 4711 1 0 100 0 0 10 0
           1: 0100007F:044A 0100007F:9999 01 00000000:00000000 00:00000000 00000000     0        0 4712 1 0 100 0 0 10 0
        """);
    Files.writeString(
        proc.resolve("net/tcp6"),
        """
          sl  local_address                         remote_address                        st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode
           0: 00000000000000000000000000000000:1040 00000000000000000000000000000000:0000 0A 00000000:00000000 00:00000000 00000000     0        0 4713 1 0 100 0 0 10 0
        """);
    Path process = Files.createDirectories(proc.resolve("17/fd")).getParent();
    Files.createSymbolicLink(process.resolve("fd/3"), Path.of("socket:[4711]"));
    Files.writeString(process.resolve("cmdline"), "java\0-cp\0x\0org.dfra.river.phoenix.Phoenix\0");

    ListeningPorts ports = new ListeningPorts(proc);
    assertThat(ports.user(1198))
        .contains(new PortUser(17, "java -cp x org.dfra.river.phoenix.Phoenix", true));
    assertThat(ports.user(1098)).as("a connection is no listener").isEmpty();
    assertThat(ports.user(4160)).as("of another user").contains(new PortUser(-1, "", false));
    assertThat(ports.user(80)).isEmpty();
  }

  @Test
  void thisComputerShowsWhichProcessListens() throws IOException {
    ListeningPorts ports = new ListeningPorts(Path.of("/proc"));
    int port;
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      port = socket.getLocalPort();
      assertThat(ports.user(port)).isPresent();
      if (Files.isReadable(Path.of("/proc/net/tcp"))) {
        assertThat(ports.user(port).orElseThrow().pid()).isEqualTo(ProcessHandle.current().pid());
      }
    }
    assertThat(ports.user(port)).isEmpty();
  }
}
