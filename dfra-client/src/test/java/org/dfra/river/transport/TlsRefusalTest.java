package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.dfra.river.transport.RecordingServer.call;

import java.io.IOException;
import java.io.OutputStream;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.OutboundRequest;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.fixture.TestTeam.Issued;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A client whose certificate a server does not believe learns that, and that nothing has run. */
@Timeout(60)
class TlsRefusalTest {

  private static final TestTeam AUTHORITY = new TestTeam("field");
  private static final Member ANNA = new Member("field", MemberRole.OPERATOR, "anna");
  private static final String REFUSED =
      " does not accept the certificate of operator anna of field, and has not executed the call";

  private final TestIdentities team = new TestIdentities(AUTHORITY);
  private final RecordingServer server =
      RecordingServer.as(team.of(MemberRole.ROBOT, "atrv1", AUTHORITY.issue(member("atrv1"))));

  /** Other programs know nothing of a revocation that the server knows. */
  private final TestIdentities others = new TestIdentities(AUTHORITY);

  private final Issued annas = AUTHORITY.issue(ANNA);
  private final ChannelIdentity anna = others.of(MemberRole.OPERATOR, "anna", annas);

  private static Member member(String robot) {
    return new Member("field", MemberRole.ROBOT, robot);
  }

  @AfterEach
  void close() {
    server.close();
  }

  /** Sends a request, and returns why it failed. */
  private static IOException failure(TransportEndpoint endpoint, int size) throws IOException {
    OutboundRequest request = endpoint.newRequest(InvocationConstraints.EMPTY).next();
    Throwable failure =
        catchThrowable(
            () -> {
              try (OutputStream out = request.getRequestOutputStream()) {
                out.write(new byte[size]);
              }
              int unused = request.getResponseInputStream().read();
            });
    request.abort();
    assertThat(failure).isInstanceOf(IOException.class);
    assertThat(request.getDeliveryStatus()).as("may have run: %s", failure).isFalse();
    return (IOException) failure;
  }

  private void revokeAnna() throws Exception {
    assertThat(team.revoke(AUTHORITY, 1, annas.certificate())).isTrue();
  }

  @Test
  void aRevokedClientLearnsThatItsCertificateIsRefused() throws Exception {
    revokeAnna();
    for (int size : new int[] {3, 300_000}) { // the larger one cannot be sent to its end
      assertThat(failure(server.from(anna), size))
          .isInstanceOf(ServerNotAcceptedException.class)
          .hasMessageContaining(REFUSED)
          .hasMessageContaining("it was revoked");
    }
    assertThat(server.dispatched()).isZero();
  }

  @Test
  void aClientWhoseSessionIsRefusedLearnsThatItsCallHasNotRunAndThenWhy() throws Exception {
    TransportEndpoint endpoint = server.from(anna);
    assertThat(call(endpoint)).hasSize(3);
    endpoint.closeIdleConnections(); // the next connection resumes its session
    revokeAnna();
    assertThat(failure(endpoint, 3)).hasMessageContaining("before it executed the call");
    assertThat(failure(endpoint, 3)).hasMessageContaining(REFUSED);
    assertThat(server.dispatched()).isEqualTo(1);
  }

  @Test
  void aClientWhoseCertificateIsNotValidYetLearnsIt() throws Exception {
    Instant tomorrow = Instant.now().plus(Duration.ofDays(1));
    Issued early = AUTHORITY.issue(ANNA.x500(), tomorrow, tomorrow.plus(Duration.ofDays(1)));
    ChannelIdentity client = others.of(MemberRole.OPERATOR, "anna", early);
    assertThat(failure(server.from(client), 3))
        .hasMessageContaining(REFUSED)
        .hasMessageContaining("is not valid yet by that computer's clock");
    assertThat(server.dispatched()).isZero();
  }

  @Test
  void aCallOfAProxySaysItInWords() throws Exception {
    revokeAnna();
    TlsDeadlineTest.Wheels wheels =
        CurrentIdentity.callAs(
            anna,
            () ->
                (TlsDeadlineTest.Wheels)
                    DeadlineILFactory.proxy(
                        new BasicObjectEndpoint(
                            new TransportEndpoint(RecordingServer.HOST, server.port()),
                            UuidFactory.generate(),
                            false),
                        Duration.ofSeconds(20),
                        getClass().getClassLoader(),
                        TlsDeadlineTest.Wheels.class,
                        RemoteMethodControl.class));
    assertThatThrownBy(wheels::drive)
        .isInstanceOf(RemoteException.class)
        .hasMessageContaining(REFUSED)
        .satisfies(it -> assertThat(ServerNotAcceptedException.isCauseOf(it)).isTrue());
    assertThat(server.dispatched()).isZero();
  }
}
