package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.Objects;
import java.util.stream.Stream;
import net.jini.id.UuidFactory;
import net.jini.jeri.ServerEndpoint;
import org.dfra.river.transport.local.ComputerId;
import org.dfra.river.transport.local.LocalSocket;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The transport over Unix-domain sockets. */
class LocalTransportTest extends TransportContract {

  @Override
  boolean finishesCalls() {
    return true;
  }

  @Override
  ServerEndpoint serverEndpoint() {
    return TransportServerEndpoint.withLocalSocket(HOST, 0);
  }

  private LocalSocket socket;

  @BeforeEach
  void findSocket() {
    assumeFalse(ComputerId.OWN.isEmpty(), "this computer has no Unix-domain sockets");
    socket = Objects.requireNonNull(((TransportEndpoint) endpoint).usableLocalSocket());
  }

  @Test
  void aCallIsAnsweredThoughItIsAbortedAfterItsEnd() throws IOException {
    assertAnsweredThoughInterruptedAndAborted();
  }

  @Test
  void onlyTheUserMayOpenTheSocket() throws IOException {
    Path file = Path.of(socket.path());
    assertThat(Files.getPosixFilePermissions(file))
        .isEqualTo(PosixFilePermissions.fromString("rw-------"));
    assertThat(Files.getPosixFilePermissions(Objects.requireNonNull(file.getParent())))
        .isEqualTo(PosixFilePermissions.fromString("rwx------"));
    assertThat(call(new byte[1])).hasSize(1);
    closePorts();
    assertThat(file).doesNotExist();
  }

  @Test
  void aClientTakesTcpIfTheSocketIsGone() throws IOException {
    Files.delete(Path.of(socket.path()));
    assertThat(call(new byte[] {3})).containsExactly(3);
  }

  @Test
  void aClientTakesTcpIfTheSocketBelongsToAnotherServer() throws IOException {
    TransportEndpoint its = (TransportEndpoint) endpoint;
    endpoint =
        new TransportEndpoint(
            its.host(),
            its.port(),
            new LocalSocket(socket.computer(), socket.path(), UuidFactory.generate()));
    assertThat(call(new byte[] {4})).containsExactly(4);
  }

  @Test
  void connectionsThatEndFreeTheirFileDescriptors() throws IOException {
    TransportEndpoint its = (TransportEndpoint) endpoint;
    assertThat(call(new byte[1])).hasSize(1);
    long before = fileDescriptors();
    for (int i = 0; i < 100; i++) {
      assertThat(call(new byte[] {1, 2})).containsExactly(1, 2);
      its.closeIdleConnections();
      send(new byte[] {3}).abort(); // its response may be on the way
      next().abort();
    }
    await()
        .atMost(Duration.ofSeconds(30))
        .untilAsserted(() -> assertThat(fileDescriptors()).isLessThanOrEqualTo(before + 10));
  }

  private static long fileDescriptors() throws IOException {
    try (Stream<Path> open = Files.list(Path.of("/proc/self/fd"))) {
      return open.count();
    }
  }

  @Test
  void theSocketOfAnotherComputerIsNotOpened() {
    TransportEndpoint its = (TransportEndpoint) endpoint;
    LocalSocket elsewhere = new LocalSocket("elsewhere", socket.path(), socket.server());
    assertThat(new TransportEndpoint(its.host(), its.port(), elsewhere).usableLocalSocket())
        .isNull();
    assertThat(new TransportEndpoint("192.0.2.1", its.port(), socket).usableLocalSocket())
        .as("a socket of this computer with the address of another one")
        .isNull();
  }

  @Test
  void anEndpointIsTheSameAfterItWasSent() throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(endpoint);
    }
    TransportEndpoint read =
        (TransportEndpoint)
            new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray())).readObject();
    assertThat(read).isEqualTo(endpoint).hasSameHashCodeAs(endpoint);
    assertThat(read.usableLocalSocket()).isEqualTo(socket);
    endpoint = read;
    assertThat(call(new byte[] {6})).containsExactly(6);
  }

  @Test
  void aRestartedServerHasAnEqualEndpointThatIsNotAsTrusted() {
    TransportEndpoint its = (TransportEndpoint) endpoint;
    TransportEndpoint restarted = new TransportEndpoint(its.host(), its.port());
    assertThat(restarted).isEqualTo(its);
    assertThat(its.checkTrustEquivalence(its)).isTrue();
    assertThat(its.checkTrustEquivalence(restarted)).isFalse();
  }

  @Test
  void aPathThatIsTooLongIsRefused() {
    assertThatThrownBy(() -> new LocalSocket("here", "x".repeat(108), UuidFactory.generate()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("the path of a socket has 108 characters; it must have 1 to 107");
  }
}
