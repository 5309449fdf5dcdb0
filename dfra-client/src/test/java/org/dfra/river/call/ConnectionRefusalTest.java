package org.dfra.river.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.net.BindException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NoRouteToHostException;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.rmi.ConnectIOException;
import java.rmi.ServerException;
import java.rmi.activation.ActivationSystem;
import java.time.Duration;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicObjectEndpoint;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Only a refused connection proves that nobody listens. */
@Timeout(60)
class ConnectionRefusalTest {

  /** What a real call ends with, at a port that is held and not listened on. */
  @Test
  void aRealRefusalIsAProof() throws Exception {
    try (Socket held = new Socket();
        Socket caller = new Socket()) {
      held.bind(new InetSocketAddress(InetAddress.getByName("127.0.0.1"), 0));
      ConnectException plain =
          catchThrowableOfType(
              ConnectException.class,
              () ->
                  caller.connect(new InetSocketAddress("127.0.0.1", held.getLocalPort()), 20_000));
      assertThat(ConnectionRefusal.isProvenBy(plain)).as(String.valueOf(plain)).isTrue();

      ActivationSystem phoenix =
          (ActivationSystem)
              DeadlineILFactory.proxy(
                  new BasicObjectEndpoint(
                      Endpoints.tcpClient("127.0.0.1", held.getLocalPort()),
                      UuidFactory.generate(),
                      false),
                  Duration.ofSeconds(20),
                  ConnectionRefusalTest.class.getClassLoader(),
                  ActivationSystem.class);
      java.rmi.ConnectException called =
          catchThrowableOfType(java.rmi.ConnectException.class, phoenix::shutdown);
      assertThat(ConnectionRefusal.isProvenBy(called)).as(String.valueOf(called)).isTrue();
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Connection timed out",
        "Operation timed out",
        "Cannot assign requested address",
        "Too many open files"
      })
  void anotherConnectExceptionIsNone(String message) {
    ConnectException failure = new ConnectException(message);
    assertThat(ConnectionRefusal.isProvenBy(failure)).isFalse();
    assertThat(
            ConnectionRefusal.isProvenBy(new java.rmi.ConnectException("no connection", failure)))
        .isFalse();
  }

  @Test
  void whateverElseKeepsAConnectionFromBeingMadeIsNone() {
    for (IOException failure :
        new IOException[] {
          new ConnectException(),
          new SocketException("Too many open files"),
          new SocketException("Network is unreachable"),
          new NoRouteToHostException("No route to host"),
          new SocketTimeoutException("Connect timed out"),
          new BindException("Cannot assign requested address"),
          new IOException("Connection refused")
        }) {
      assertThat(ConnectionRefusal.isProvenBy(failure)).as(failure.toString()).isFalse();
      assertThat(ConnectionRefusal.isProvenBy(new ConnectIOException("no connection", failure)))
          .as(failure.toString())
          .isFalse();
    }
    assertThat(ConnectionRefusal.isProvenBy(new java.rmi.ConnectException("Connection refused")))
        .as("without a cause nobody knows")
        .isFalse();
  }

  /** The server answered: it was another that somebody refused. */
  @Test
  void whatAServerReportsOfItsOwnCallsIsNone() {
    ConnectException elsewhere = new ConnectException("Connection refused");
    assertThat(
            ConnectionRefusal.isProvenBy(
                new ServerException(
                    "failed", new java.rmi.ConnectException("no connection", elsewhere))))
        .isFalse();
    assertThat(ConnectionRefusal.isProvenBy(new IllegalStateException(elsewhere))).isFalse();
  }
}
