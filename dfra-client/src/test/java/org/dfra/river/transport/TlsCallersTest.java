package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;
import static org.dfra.river.transport.RecordingServer.call;

import java.io.IOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.security.GeneralSecurityException;
import java.security.SecureRandom;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManager;
import javax.net.ssl.X509TrustManager;
import javax.security.auth.x500.X500Principal;
import net.jini.core.constraint.ClientAuthentication;
import net.jini.core.constraint.ClientMinPrincipal;
import net.jini.core.constraint.Confidentiality;
import net.jini.core.constraint.ConstraintAlternatives;
import net.jini.core.constraint.Delegation;
import net.jini.core.constraint.Integrity;
import net.jini.core.constraint.InvocationConstraint;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.constraint.ServerAuthentication;
import net.jini.core.constraint.ServerMinPrincipal;
import net.jini.io.UnsupportedConstraintException;
import net.jini.io.context.ClientSubject;
import org.bouncycastle.asn1.x509.KeyPurposeId;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.fixture.TestTeam.Issued;
import org.dfra.river.identity.AnonymousIdentity;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.security.Caller;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class TlsCallersTest {

  private static final String HOST = RecordingServer.HOST;
  private static final TestTeam AUTHORITY = new TestTeam("field");
  private static final TestTeam OTHER = new TestTeam("field");

  private static final Member ATRV1 = new Member("field", MemberRole.ROBOT, "atrv1");
  private static final Member ANNA = new Member("field", MemberRole.OPERATOR, "anna");

  private final TestIdentities team = new TestIdentities(AUTHORITY);
  private final ChannelIdentity robot = team.of(MemberRole.ROBOT, "atrv1");
  private final Issued anna = AUTHORITY.issue(ANNA);
  private final ChannelIdentity operator = team.of(MemberRole.OPERATOR, "anna", anna);

  private final RecordingServer server = RecordingServer.as(robot);

  @AfterEach
  void close() {
    server.close();
  }

  private TransportEndpoint from(ChannelIdentity client) {
    return server.from(client);
  }

  private static InvocationConstraints required(InvocationConstraint... constraints) {
    return new InvocationConstraints(constraints, new InvocationConstraint[0]);
  }

  @Test
  void theServerKnowsItsCallers() throws IOException {
    assertThat(call(from(operator))).containsExactly(1, 2, 3);
    Caller caller = server.last(Caller.class);
    assertThat(caller.standing()).isEqualTo(Caller.Standing.MEMBER);
    assertThat(caller.member()).contains(ANNA);
    assertThat(server.last(ClientSubject.class).getClientSubject().getPrincipals())
        .contains(anna.certificate().getSubjectX500Principal());
  }

  @Test
  void theOwnProcessesAreOwnEvenWhenTheCertificateHasExpired() throws IOException {
    Instant now = Instant.now();
    ChannelIdentity late =
        team.of(
            MemberRole.ROBOT,
            "atrv1",
            AUTHORITY.issue(
                ATRV1.x500(), now.minus(Duration.ofDays(2)), now.minus(Duration.ofDays(1))));
    try (RecordingServer own = RecordingServer.as(late)) {
      assertThat(call(own.from(late))).containsExactly(1, 2, 3);
      assertThat(own.last(Caller.class).standing()).isEqualTo(Caller.Standing.OWN);
      assertThatThrownBy(() -> call(own.from(operator)))
          .hasMessageContaining("robot atrv1 of field is not called or answered")
          .hasMessageContaining("its certificate is valid from");
    }
  }

  @Test
  void aClientWithoutCertificateIsAStranger() throws IOException {
    assertThat(call(from(AnonymousIdentity.instance()))).containsExactly(1, 2, 3);
    Caller caller = server.last(Caller.class);
    assertThat(caller.standing()).isEqualTo(Caller.Standing.STRANGER);
    assertThat(caller.member()).isEqualTo(Optional.empty());
  }

  @Test
  void anExpiredMemberIsMarked() throws IOException {
    Instant now = Instant.now();
    Issued expired =
        AUTHORITY.issue(
            ANNA.x500(), now.minus(Duration.ofDays(2)), now.minus(Duration.ofSeconds(2)));
    assertThat(call(from(team.of(MemberRole.OPERATOR, "anna", expired)))).hasSize(3);
    assertThat(server.last(Caller.class).standing()).isEqualTo(Caller.Standing.EXPIRED);
  }

  @Test
  void noOtherCertificateIsAccepted() {
    Instant now = Instant.now();
    Instant soon = now.plusSeconds(900);
    X500Principal mallory = new Member("field", MemberRole.OPERATOR, "mallory").x500();
    X500Principal elsewhere = new Member("woods", MemberRole.OPERATOR, "anna").x500();
    Issued early = AUTHORITY.issue(mallory, now.plusSeconds(600), soon);
    Issued coder = AUTHORITY.issue(mallory, now, soon, KeyPurposeId.id_kp_codeSigning);
    Issued serving = AUTHORITY.issue(mallory, now, soon, KeyPurposeId.id_kp_serverAuth);
    Issued forged = OTHER.issue(mallory, now, soon);
    Issued foreign = AUTHORITY.issue(elsewhere, now, soon);
    Issued self = TestTeam.robotKey("atrv1");
    List<Issued> refused = List.of(early, coder, serving, forged, foreign, self);
    int before = server.dispatched();
    for (Issued each : refused) {
      ChannelIdentity client = team.of(MemberRole.OPERATOR, "mallory", each);
      assertThatThrownBy(() -> call(from(client)))
          .as("%s", each.certificate())
          .isInstanceOf(IOException.class);
    }
    assertThat(server.dispatched()).isEqualTo(before);
  }

  @Test
  void aServerOfAnotherAuthorityIsNotCalled() throws IOException {
    ChannelIdentity rogue = new TestIdentities(OTHER).of(MemberRole.ROBOT, "atrv1");
    try (RecordingServer fake = RecordingServer.as(rogue)) {
      assertThatThrownBy(() -> call(fake.from(operator)))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("do not accept each other")
          .hasMessageContaining("the certificate of CN=atrv1,OU=robot,O=field is not of");
      assertThat(fake.dispatched()).isZero();
    }
  }

  @Test
  void neitherSideFallsBackToPlainCalls() throws IOException {
    TransportEndpoint plain = new TransportEndpoint(HOST, server.port());
    assertThatThrownBy(() -> call(plain))
        .hasMessageEndingWith(
            "refuses a connection: it serves members of its team only; join the team on this"
                + " computer (security join)");
    try (RecordingServer open = RecordingServer.open()) {
      assertThatThrownBy(() -> call(open.from(operator)))
          .hasMessageEndingWith(
              "refuses a connection: it has joined no team, so its calls are not encrypted");
    }
  }

  @Test
  void olderTlsIsRefused() throws Exception {
    SSLContext context = SSLContext.getInstance("TLS");
    context.init(null, new TrustManager[] {new BelievesAll()}, new SecureRandom());
    for (String protocol : List.of("TLSv1.2", "TLSv1.3")) {
      try (Socket plain = new Socket(HOST, server.port())) {
        ByteBuffer greeting = ByteBuffer.allocate(Greeting.CLIENT_BYTES);
        Greeting.putClient(greeting, Greeting.ANY_SERVER, true, false);
        plain.getOutputStream().write(greeting.array());
        assertThat(plain.getInputStream().readNBytes(Greeting.SERVER_BYTES)[5]).isZero();
        SSLSocket socket =
            (SSLSocket) context.getSocketFactory().createSocket(plain, HOST, 0, true);
        socket.setEnabledProtocols(new String[] {protocol});
        if (protocol.equals("TLSv1.2")) {
          assertThatThrownBy(socket::startHandshake).isInstanceOf(IOException.class);
        } else {
          socket.startHandshake();
          assertThat(socket.getSession().getProtocol()).isEqualTo(protocol);
        }
      }
    }
  }

  private static final class BelievesAll implements X509TrustManager {
    @Override
    public void checkClientTrusted(X509Certificate[] chain, String type) {}

    @Override
    public void checkServerTrusted(X509Certificate[] chain, String type) {}

    @Override
    public X509Certificate[] getAcceptedIssuers() {
      return new X509Certificate[0];
    }
  }

  @Test
  void revocationEndsOpenConnectionsAndResumedSessions()
      throws IOException, GeneralSecurityException {
    TransportEndpoint annas = from(operator);
    assertThat(call(annas)).hasSize(3);
    int before = server.dispatched();
    assertThat(team.revoke(AUTHORITY, 1, anna.certificate())).isTrue();
    await()
        .atMost(Duration.ofSeconds(10))
        .untilAsserted(
            () -> {
              assertThatThrownBy(() -> call(annas)).isInstanceOf(IOException.class);
            });
    annas.closeIdleConnections();
    assertThatThrownBy(() -> call(annas)).isInstanceOf(IOException.class);
    assertThat(server.callersFrom(before))
        .allSatisfy(each -> assertThat(each.standing()).isEqualTo(Caller.Standing.STRANGER));
    assertThat(team.revoke(AUTHORITY, 1)).as("an older list").isFalse();
    assertThatThrownBy(() -> team.revoke(OTHER, 2)).isInstanceOf(GeneralSecurityException.class);
  }

  @Test
  void constraintsAreAnsweredTruthfully() throws IOException {
    TransportEndpoint annas = from(operator);
    X509Certificate other =
        AUTHORITY.issue(new Member("field", MemberRole.ROBOT, "atrv2")).certificate();
    Set<InvocationConstraints> met =
        Set.of(
            required(Confidentiality.YES, ServerAuthentication.YES, ClientAuthentication.YES),
            required(Integrity.YES, Delegation.NO),
            required(new ServerMinPrincipal(ATRV1.x500())),
            required(new ClientMinPrincipal(anna.certificate().getSubjectX500Principal())),
            required(
                new ConstraintAlternatives(
                    new InvocationConstraint[] {
                      new ServerMinPrincipal(other.getSubjectX500Principal()),
                      ServerAuthentication.YES
                    })));
    for (InvocationConstraints each : met) {
      assertThat(call(annas, each)).as("%s", each).hasSize(3);
    }
    int before = server.dispatched();
    Set<InvocationConstraints> unmet =
        Set.of(
            required(Confidentiality.NO),
            required(Integrity.NO),
            required(ServerAuthentication.NO),
            required(ClientAuthentication.NO),
            required(Delegation.YES),
            required(new ServerMinPrincipal(other.getSubjectX500Principal())),
            required(new ClientMinPrincipal(other.getSubjectX500Principal())));
    for (InvocationConstraints each : unmet) {
      assertThatThrownBy(() -> call(annas, each))
          .as("%s", each)
          .isInstanceOf(UnsupportedConstraintException.class);
    }
    assertThatThrownBy(
            () -> call(from(AnonymousIdentity.instance()), required(ServerAuthentication.YES)))
        .isInstanceOf(UnsupportedConstraintException.class);
    assertThat(server.dispatched()).isEqualTo(before);
  }
}
