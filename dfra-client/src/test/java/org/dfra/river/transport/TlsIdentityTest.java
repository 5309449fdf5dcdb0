package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;
import static org.dfra.river.transport.RecordingServer.call;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import java.math.BigInteger;
import java.net.InetAddress;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLSession;
import javax.security.auth.Subject;
import javax.security.auth.x500.X500Principal;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.io.context.ClientSubject;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.ServerEndpoint.ListenHandle;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.fixture.TestTeam.Issued;
import org.dfra.river.identity.AnonymousIdentity;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.ChannelPeer;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Guard;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Whose keys and certificates are believed while connections are open and sessions are resumed. */
@Timeout(60)
class TlsIdentityTest {

  private static final TestTeam AUTHORITY = new TestTeam("field");
  private static final Member ATRV1 = new Member("field", MemberRole.ROBOT, "atrv1");
  private static final String ELSEWHERE = "127.0.0.88"; // no address of this computer's own

  private static final long FAR_AWAY_NANOS = TimeUnit.SECONDS.toNanos(5);

  private final TestIdentities team = new TestIdentities(AUTHORITY);

  /** A call from another address of the loopback. */
  private static byte[] callFrom(String source, TransportEndpoint to) throws IOException {
    ClientConnections connections = ClientConnections.to(to, InetAddress.getByName(source), 0);
    OutboundRequest request = RequestIterator.of(connections, InvocationConstraints.EMPTY).next();
    try (OutputStream out = request.getRequestOutputStream()) {
      out.write(1);
    }
    try (InputStream in = request.getResponseInputStream()) {
      return in.readAllBytes();
    } finally { // the watchdog may have replaced the list meanwhile
      ClientConnections.to(to, InetAddress.getByName(source), 0).closeIdle();
    }
  }

  @Test
  void aStolenOwnKeyThatIsRevokedIsNobodysElsewhere() throws Exception {
    Issued own = AUTHORITY.issue(ATRV1);
    ChannelIdentity robot = team.of(MemberRole.ROBOT, "atrv1", own);
    Issued renamed =
        TestTeam.certify(own, new X500Principal("CN=anna,OU=operator,O=field")); // by itself
    ChannelIdentity thief = team.of(MemberRole.ROBOT, "atrv1", renamed);
    try (RecordingServer server = RecordingServer.as(robot)) {
      assertThat(callFrom(ELSEWHERE, server.from(thief))).hasSize(1);
      assertThat(server.last(Caller.class).standing()).isEqualTo(Standing.OWN);
      assertThat(server.last(ClientSubject.class).getClientSubject().getPrincipals())
          .as("a name that nobody has checked")
          .doesNotContain(new X500Principal("CN=anna,OU=operator,O=field"));
      assertThat(team.revoke(AUTHORITY, 1, own.certificate())).isTrue();
      int before = server.dispatched();
      for (ChannelIdentity each : List.of(thief, robot)) {
        assertThatThrownBy(() -> callFrom(ELSEWHERE, server.from(each)))
            .isInstanceOf(IOException.class);
      }
      assertThat(server.dispatched()).isEqualTo(before);
      assertThat(call(server.from(robot))).as("on this computer").hasSize(3);
    }
  }

  @Test
  void anOwnKeyThatTheAuthorityDoesNotKnowIsForOneComputer() throws Exception {
    Issued own = AUTHORITY.issue(ATRV1);
    TeamIdentity robot = team.of(MemberRole.ROBOT, "atrv1", own);
    ChannelIdentity copied =
        team.of(MemberRole.ROBOT, "atrv1", TestTeam.certify(own, new X500Principal("CN=any")));
    List<SSLSession> sessions = new CopyOnWriteArrayList<>();
    AtomicReference<@Nullable ChannelPeer> seen = new AtomicReference<>();
    try (RecordingServer server = RecordingServer.as(new Observed(robot, seen, sessions))) {
      assertThat(call(server.from(copied))).hasSize(3);
      assertThat(call(server.from(robot))).hasSize(3);
    }
    SSLSession withoutIssuer = sessions.get(0);
    SSLSession issued = sessions.get(1);
    for (boolean isServer : new boolean[] {false, true}) {
      assertThatThrownBy(() -> robot.peer(withoutIssuer, "192.0.2.7", isServer))
          .hasMessageContaining("which is for this computer only");
      assertThat(robot.peer(issued, "192.0.2.7", isServer).caller().standing())
          .isEqualTo(Standing.OWN);
      assertThat(robot.peer(withoutIssuer, "127.0.0.1", isServer).caller().standing())
          .isEqualTo(Standing.OWN);
    }
  }

  @Test
  void anotherMemberWithTheOwnNameIsOwnOnlyWhileItsCertificateIsValid() throws IOException {
    ChannelIdentity robot = team.of(MemberRole.ROBOT, "atrv1");
    Instant now = Instant.now();
    ChannelIdentity before =
        team.of(
            MemberRole.ROBOT,
            "atrv1",
            AUTHORITY.issue(
                ATRV1.x500(), now.minus(Duration.ofDays(9)), now.minus(Duration.ofDays(1))));
    ChannelIdentity person = team.of(MemberRole.OPERATOR, "atrv1");
    try (RecordingServer server = RecordingServer.as(robot)) {
      assertStanding(server, team.of(MemberRole.ROBOT, "atrv1"), Standing.OWN);
      assertStanding(server, before, Standing.EXPIRED);
      assertStanding(server, person, Standing.MEMBER);
    }
  }

  private static void assertStanding(
      RecordingServer server, ChannelIdentity client, Standing expected) throws IOException {
    assertThat(call(server.from(client))).hasSize(3);
    assertThat(server.last(Caller.class).standing()).isEqualTo(expected);
  }

  @Test
  void anIdleConnectionIsClosedSoonAfterRevocation() throws Exception {
    Issued anna = AUTHORITY.issue(new Member("field", MemberRole.OPERATOR, "anna"));
    ChannelIdentity operator = team.of(MemberRole.OPERATOR, "anna", anna);
    try (RecordingServer server = RecordingServer.as(team.of(MemberRole.ROBOT, "atrv1"));
        RawTls idle = RawTls.connected("127.0.0.66", server.port(), operator)) {
      idle.send(idle.block(Block.Kind.END, new byte[] {7}));
      assertThat(idle.readData(5)).hasSize(5);
      idle.send(idle.block(Block.Kind.PAUSE, new byte[0]));
      await("all connections are idle, so the next check is far away")
          .atMost(Duration.ofSeconds(30))
          .until(() -> ConnectionSelector.instance().nanosUntilCheck() > FAR_AWAY_NANOS);
      assertThat(team.revoke(AUTHORITY, 1, anna.certificate())).isTrue();
      idle.socket().setSoTimeout(1000);
      assertThat(idle.readRawToEnd()).as("within a second").isEmpty();
    }
  }

  @Test
  void aRevokedClientIsNoLongerInRiversContext() throws Exception {
    Issued anna = AUTHORITY.issue(new Member("field", MemberRole.OPERATOR, "anna"));
    ChannelIdentity robot = team.of(MemberRole.ROBOT, "atrv1");
    ChannelIdentity operator = team.of(MemberRole.OPERATOR, "anna", anna);
    AtomicReference<@Nullable ChannelPeer> seen = new AtomicReference<>();
    try (RecordingServer server =
        RecordingServer.as(new Observed(robot, seen, new ArrayList<>()))) {
      assertThat(call(server.from(operator))).hasSize(3);
      ChannelPeer peer = seen.get();
      assertThat(peer.subject().getPrincipals())
          .contains(anna.certificate().getSubjectX500Principal());
      assertThat(team.revoke(AUTHORITY, 1, anna.certificate())).isTrue();
      assertThat(peer.subject().getPrincipals()).isEmpty();
      assertThat(peer.caller().standing()).isEqualTo(Standing.STRANGER);
    }
  }

  /** Notes the peers. */
  private record Observed(
      ChannelIdentity identity,
      AtomicReference<@Nullable ChannelPeer> seen,
      List<SSLSession> sessions)
      implements ChannelIdentity {

    @Override
    public SSLEngine clientEngine(String host, int port) {
      return identity.clientEngine(host, port);
    }

    @Override
    public SSLEngine serverEngine() {
      return identity.serverEngine();
    }

    @Override
    public ChannelPeer peer(SSLSession session, String address, boolean isServer)
        throws IOException {
      ChannelPeer peer = identity.peer(session, address, isServer);
      seen.set(peer);
      sessions.add(session);
      return peer;
    }

    @Override
    public Subject subject() {
      return identity.subject();
    }

    @Override
    public String robot() {
      return identity.robot();
    }

    @Override
    public InvocationConstraints requiredOfRobot(String name) {
      return identity.requiredOfRobot(name);
    }

    @Override
    public boolean isRevoked(BigInteger certificate) {
      return identity.isRevoked(certificate);
    }

    @Override
    public void addRevocationListener(Runnable listener) {
      identity.addRevocationListener(listener);
    }

    @Override
    public void removeRevocationListener(Runnable listener) {
      identity.removeRevocationListener(listener);
    }

    @Override
    public Guard guard() {
      return identity.guard();
    }
  }

  @Test
  void aServerThatExpiresIsNotCalledOnItsOpenConnection() throws IOException {
    SteppedClock clock = new SteppedClock();
    ChannelIdentity operator = team.withClock(MemberRole.OPERATOR, "anna", clock);
    try (RecordingServer server = RecordingServer.as(team.of(MemberRole.ROBOT, "atrv1"))) {
      TransportEndpoint endpoint = server.from(operator);
      assertThat(call(endpoint)).hasSize(3);
      clock.now = Instant.now().plus(Duration.ofDays(2)); // certificates are valid for one
      int before = server.dispatched();
      assertThatThrownBy(() -> call(endpoint)).hasMessageContaining("is not called or answered");
      assertThat(server.dispatched()).isEqualTo(before);
    }
  }

  private static final class SteppedClock extends Clock {
    volatile Instant now = Instant.now();

    @Override
    public ZoneId getZone() {
      return ZoneId.of("UTC");
    }

    @Override
    public Clock withZone(ZoneId zone) {
      return this;
    }

    @Override
    public Instant instant() {
      return now;
    }
  }

  @Test
  void identitiesOfOneVirtualMachineDoNotShareSessions() throws IOException {
    try (RecordingServer server = RecordingServer.as(team.of(MemberRole.ROBOT, "atrv1"))) {
      for (int i = 0; i < 3; i++) {
        for (String name : List.of("anna", "bert")) {
          TransportEndpoint endpoint = server.from(clients.of(name));
          assertThat(call(endpoint)).hasSize(3);
          assertThat(server.last(Caller.class).member().orElseThrow().name()).isEqualTo(name);
          endpoint.closeIdleConnections(); // the next one resumes its session
        }
      }
      TransportEndpoint stranger = server.from(AnonymousIdentity.instance());
      assertThat(call(stranger)).hasSize(3);
      assertThat(server.last(Caller.class).standing()).isEqualTo(Standing.STRANGER);
    }
  }

  private final Clients clients = new Clients();

  private final class Clients {
    private final Map<String, ChannelIdentity> known = new HashMap<>();

    ChannelIdentity of(String name) {
      return known.computeIfAbsent(name, it -> team.of(MemberRole.OPERATOR, it));
    }
  }

  @Test
  void anotherServerAtTheSamePortIsAuthenticatedAgain() throws IOException {
    ChannelIdentity operator = team.of(MemberRole.OPERATOR, "anna");
    int port;
    try (RecordingServer first = RecordingServer.as(team.of(MemberRole.ROBOT, "atrv1"))) {
      port = first.port();
      assertThat(call(first.from(operator))).hasSize(3);
      first.from(operator).closeIdleConnections();
    }
    try (RecordingServer second = RecordingServer.at(port, team.of(MemberRole.ROBOT, "atrv2"))) {
      TransportEndpoint endpoint = second.from(operator);
      assertThat(call(endpoint, operator.requiredOfRobot("atrv2"))).hasSize(3);
      assertThatThrownBy(() -> call(endpoint, operator.requiredOfRobot("atrv1")))
          .hasMessageContaining("does not meet");
    }
  }

  @Test
  void endpointsInArgumentsGetTheIdentityOfTheCalledObject() throws Exception {
    ChannelIdentity robot = team.of(MemberRole.ROBOT, "atrv1");
    List<@Nullable ChannelIdentity> received = new CopyOnWriteArrayList<>();
    List<ListenHandle> handles = new ArrayList<>();
    TransportEndpoint listening =
        (TransportEndpoint)
            RecordingServer.endpoint(robot)
                .enumerateListenEndpoints(
                    each -> {
                      ListenHandle handle =
                          each.listen(
                              request -> {
                                try (ObjectInputStream in =
                                        new ObjectInputStream(request.getRequestInputStream());
                                    OutputStream out = request.getResponseOutputStream()) {
                                  received.add(((TransportEndpoint) in.readObject()).identity());
                                  out.write(1);
                                } catch (IOException | ClassNotFoundException e) {
                                  request.abort();
                                }
                              });
                      handles.add(handle);
                      return handle.getCookie();
                    });
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(new TransportEndpoint("127.0.0.1", 1));
    }
    OutboundRequest request = listening.newRequest(InvocationConstraints.EMPTY).next();
    try (OutputStream out = request.getRequestOutputStream()) {
      out.write(bytes.toByteArray());
    }
    try (InputStream in = request.getResponseInputStream()) {
      assertThat(in.readAllBytes()).hasSize(1);
    }
    handles.forEach(ListenHandle::close);
    assertThat(received).hasSize(1);
    assertThat(received.get(0)).isSameAs(robot);
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
      assertThat(((TransportEndpoint) in.readObject()).identity()).isNull();
    }
  }

  @Test
  void strangersOfferNoOlderTls() {
    assertThat(AnonymousIdentity.instance().clientEngine("127.0.0.1", 1).getEnabledProtocols())
        .containsExactly("TLSv1.3");
  }

  @Test
  void theNameInAnUnknownCertificateIsPrintable() throws IOException {
    TestTeam other = new TestTeam("field");
    Instant now = Instant.now();
    Issued forged =
        other.issue(
            new X500Principal("CN=atrv1\u001b[2J\nall is well,OU=robot,O=field"),
            now.minusSeconds(9),
            now.plusSeconds(900));
    ChannelIdentity rogue = new TestIdentities(other).of(MemberRole.ROBOT, "atrv1", forged);
    try (RecordingServer fake = RecordingServer.as(rogue)) {
      assertThatThrownBy(() -> call(fake.from(team.of(MemberRole.OPERATOR, "anna"))))
          .hasMessageContaining("do not accept each other")
          .message()
          .doesNotContain("\u001b", "\n");
    }
  }
}
