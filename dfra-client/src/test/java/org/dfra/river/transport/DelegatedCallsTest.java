package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.UnmarshalException;
import java.rmi.server.ServerNotActiveException;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.export.ServerContext;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.OutboundRequest;
import org.dfra.river.access.CallCredential;
import org.dfra.river.access.GuardedObject;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.fixture.TestTeam.Issued;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.ChannelPeer;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.identity.Delegation;
import org.dfra.river.identity.FlooredClock;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.security.AccessRequest;
import org.dfra.security.Behalf;
import org.dfra.security.Caller;
import org.dfra.security.Decision;
import org.dfra.security.Guard;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Calls that carry an operator's delegation: what the called object's guard learns of the caller.
 */
@Timeout(60)
class DelegatedCallsTest {

  /** What the test calls. */
  public interface Wheels extends Remote {
    int drive(int speed) throws RemoteException;
  }

  private static final class WheelsImpl implements Wheels, GuardedObject {
    @Override
    public int drive(int speed) {
      return speed;
    }

    @Override
    public String guardedName() {
      return "drive";
    }
  }

  private static final Member ATRV1 = new Member("field", MemberRole.ROBOT, "atrv1");
  private static final Member ATRV2 = new Member("field", MemberRole.ROBOT, "atrv2");
  private static final Member ANNA = new Member("field", MemberRole.OPERATOR, "anna");

  private final TestTeam authority = new TestTeam("field");
  private final TestIdentities team = new TestIdentities(authority);
  private final Issued anna = authority.issue(ANNA);
  private final Issued atrv1 = authority.issue(ATRV1);
  private final TeamIdentity bearer = team.of(MemberRole.ROBOT, "atrv1", atrv1);
  private final AtomicReference<Instant> now = new AtomicReference<>(Instant.now());
  private final List<AccessRequest> requests = new CopyOnWriteArrayList<>();
  private final AtomicReference<@Nullable ChannelPeer> peer = new AtomicReference<>();
  private final Uuid id = UuidFactory.generate();
  private final WheelsImpl impl = new WheelsImpl(); // an exporter refers to it weakly
  private BasicJeriExporter exporter;
  private int port;

  /** The robot's clock. */
  private final Clock clock =
      new Clock() {
        @Override
        public ZoneOffset getZone() {
          return ZoneOffset.UTC;
        }

        @Override
        public Clock withZone(java.time.ZoneId zone) {
          return this;
        }

        @Override
        public Instant instant() {
          return now.get();
        }
      };

  private Decision decide(AccessRequest request) {
    requests.add(request);
    try {
      peer.set((ChannelPeer) ServerContext.getServerContextElement(ChannelPeer.class));
    } catch (ServerNotActiveException e) {
      throw new IllegalStateException(e);
    }
    return Decision.permit("all");
  }

  @BeforeEach
  void export() throws Exception {
    export(clock);
  }

  private void export(InstantSource time) throws Exception {
    Guard guard = this::decide;
    TeamIdentity robot = team.guardedWithClock(MemberRole.ROBOT, "atrv2", guard, time);
    exporter =
        new BasicJeriExporter(
            RecordingServer.endpoint(robot), new DeadlineILFactory(), false, true, id);
    port = Objects.requireNonNull(PeerAddress.of(exporter.export(impl))).port();
  }

  @AfterEach
  void unexport() {
    exporter.unexport(true);
  }

  private Wheels from(ChannelIdentity client) {
    return CurrentIdentity.callAs(
        client,
        () ->
            (Wheels)
                DeadlineILFactory.proxy(
                    new BasicObjectEndpoint(
                        new TransportEndpoint(RecordingServer.HOST, port), id, false),
                    Duration.ofSeconds(2),
                    getClass().getClassLoader(),
                    Wheels.class));
  }

  private Delegation delegation(Member to, Issued toWhom, List<String> robots, Duration length) {
    Instant issued = Instant.now();
    return Delegation.sign(
        ANNA,
        anna.key(),
        anna.certificate(),
        to,
        Delegation.fingerprint(toWhom.certificate()),
        robots,
        issued,
        issued.plus(length));
  }

  private Delegation usual() {
    return delegation(ATRV1, atrv1, List.of("atrv2"), Duration.ofHours(2));
  }

  private Caller caller(TeamIdentity client, byte[] carried) throws Exception {
    client.carry((method, server) -> server.equals(ATRV2) ? carried : null);
    assertThat(from(client).drive(3)).isEqualTo(3);
    return requests.get(requests.size() - 1).caller();
  }

  private static String fault(Caller caller) {
    return caller.behalf().map(Behalf::fault).orElse("");
  }

  @Test
  void aCallWithoutOneIsOnItsOwnBehalfAndOneWithItNamesBoth() throws Exception {
    assertThat(from(bearer).drive(1)).isEqualTo(1);
    assertThat(requests.get(0).caller().behalf()).isEmpty();
    Caller caller = caller(bearer, usual().bytes());
    assertThat(caller.member()).contains(ATRV1);
    assertThat(caller.behalf()).contains(Behalf.of(ANNA));
    assertThat(caller).hasToString("robot atrv1 of field for operator anna of field (127.0.0.1)");
    assertThat(Objects.requireNonNull(peer.get()).caller()).isEqualTo(caller);
    bearer.carry((method, server) -> null);
    assertThat(from(bearer).drive(2)).isEqualTo(2);
    assertThat(requests.get(2).caller().behalf()).as("on the same connection").isEmpty();
  }

  @Test
  void itIsOfNoUseToAnotherMemberNorWithAnotherCertificate() throws Exception {
    byte[] stolen = usual().bytes();
    Caller thief = caller(team.of(MemberRole.ROBOT, "atrv3"), stolen);
    assertThat(thief.behalf().flatMap(Behalf::principal)).isEmpty();
    assertThat(fault(thief)).contains("does not count for robot atrv3 of field");
    Caller renewed = caller(team.of(MemberRole.ROBOT, "atrv1"), stolen);
    assertThat(fault(renewed)).contains("for the certificate that robot atrv1 of field had");
  }

  @Test
  void itCountsForItsRobotsAndItsTimeOnly() throws Exception {
    Delegation elsewhere = delegation(ATRV1, atrv1, List.of("atrv7"), Duration.ofHours(1));
    assertThat(fault(caller(bearer, elsewhere.bytes())))
        .contains("is for atrv7, and not for robot atrv2 of field");
    byte[] usual = usual().bytes();
    assertThat(fault(caller(bearer, usual))).isEmpty();
    ChannelPeer granted = Objects.requireNonNull(peer.get());
    assertThat(granted.isRevoked()).isFalse();
    now.set(Instant.now().plus(Duration.ofHours(3)));
    assertThat(fault(caller(bearer, usual))).contains("has expired");
    assertThat(granted.isRevoked()).as("a lease that it acquired").isTrue();
    now.set(Instant.now().minus(Duration.ofHours(1)));
    Caller early = caller(bearer, usual);
    assertThat(fault(early)).contains("set the clocks");
    now.set(now.get().plusNanos(1));
    assertThat(caller(bearer, usual)).as("the audit trail sums equal ones").isEqualTo(early);
  }

  /** Its own time would stand still, and the delegation would last for as long as it does. */
  @Test
  void itDoesNotCountForARobotWhoseClockWasNotSet() throws Exception {
    exporter.unexport(true);
    FlooredClock unset = new FlooredClock(clock, Instant.now(), Instant.MAX);
    export(unset);
    byte[] usual = usual().bytes();
    assertThat(fault(caller(bearer, usual))).isEmpty();
    ChannelPeer granted = Objects.requireNonNull(peer.get());
    now.set(Instant.EPOCH);
    assertThat(fault(caller(bearer, usual))).contains("clock of robot atrv2 of field was not set");
    assertThat(granted.isRevoked()).as("a lease that it acquired").isTrue();
  }

  @Test
  void anOperatorCannotLoseItsOwnRightByOne() {
    assertThatThrownBy(
            () ->
                delegation(
                    new Member("field", MemberRole.OPERATOR, "ben"),
                    atrv1,
                    List.of("atrv2"),
                    Duration.ofHours(1)))
        .hasMessage(
            "this cannot be delegated: it is to operator ben of field, and operators command for"
                + " themselves");
  }

  @Test
  void itEndsWhenTheOneWhoHasDelegatedIsRevoked() throws Exception {
    byte[] usual = usual().bytes();
    assertThat(fault(caller(bearer, usual))).isEmpty();
    ChannelPeer granted = Objects.requireNonNull(peer.get());
    assertThat(team.revoke(authority, 1, anna.certificate())).isTrue();
    assertThat(fault(caller(bearer, usual))).contains("operator anna of field is revoked");
    assertThat(granted.isRevoked()).isTrue();
  }

  @Test
  void onlyAnOperatorOfTheTeamCanSignOne() throws Exception {
    Issued otto = authority.issue(new Member("field", MemberRole.OBSERVER, "otto"));
    Instant issued = Instant.now();
    String fingerprint = Delegation.fingerprint(atrv1.certificate());
    assertThatThrownBy(
            () ->
                Delegation.sign(
                    new Member("field", MemberRole.OBSERVER, "otto"),
                    otto.key(),
                    otto.certificate(),
                    ATRV1,
                    fingerprint,
                    List.of("atrv2"),
                    issued,
                    issued.plusSeconds(60)))
        .hasMessageContaining("only operators delegate");
    Issued falseAnna = new TestTeam("field").issue(ANNA);
    Delegation ofOthers =
        Delegation.sign(
            ANNA,
            falseAnna.key(),
            falseAnna.certificate(),
            ATRV1,
            fingerprint,
            List.of("atrv2"),
            issued,
            issued.plusSeconds(60));
    assertThat(fault(caller(bearer, ofOthers.bytes()))).contains("does not count");
    String longer = usual().text().replace("robots: atrv2", "robots: atrv2,atrv3");
    assertThat(fault(caller(bearer, longer.getBytes(StandardCharsets.US_ASCII))))
        .contains("was changed");
    assertThat(fault(caller(bearer, new byte[] {1, 2, 3}))).contains("is no delegation");
    assertThatThrownBy(() -> delegation(ATRV1, atrv1, List.of("atrv2"), Duration.ofHours(25)))
        .hasMessageContaining("at most 24 h");
  }

  @Test
  void aStrangerActsForNobody() throws Exception {
    Wheels stranger = CurrentIdentity.callAsStranger(() -> from(CurrentIdentity.get()));
    assertThat(stranger.drive(1)).isEqualTo(1);
    byte[] answer = raw(CurrentIdentity.callAsStranger(CurrentIdentity::get), usual().bytes(), -1);
    assertThat(answer[0]).isEqualTo((byte) 1);
    assertThat(requests.get(1).caller().member()).isEmpty();
    assertThat(requests.get(1).caller().behalf()).isEmpty();
  }

  /** The bytes of a call of {@code drive(int)}, with a credential whose length may be false. */
  private byte[] raw(@Nullable ChannelIdentity client, byte[] carried, int length)
      throws Exception {
    TransportEndpoint endpoint =
        CurrentIdentity.callAs(
            Objects.requireNonNull(client),
            () -> new TransportEndpoint(RecordingServer.HOST, port));
    OutboundRequest request =
        RequestIterator.of(ClientConnections.to(endpoint), InvocationConstraints.EMPTY).next();
    ByteArrayOutputStream arguments = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(arguments)) {
      out.writeLong(CallCredential.MARK);
      out.writeByte(1);
      out.writeShort(length < 0 ? carried.length : length);
      out.write(carried);
      out.writeLong(number(Wheels.class.getMethod("drive", int.class)));
      out.writeInt(3);
    }
    try (OutputStream out = request.getRequestOutputStream()) {
      out.write(bytes(id));
      out.write(0);
      out.write(0);
      out.write(arguments.toByteArray());
    }
    try (InputStream in = request.getResponseInputStream()) {
      return in.readAllBytes();
    }
  }

  private static byte[] bytes(Uuid id) {
    return java.nio.ByteBuffer.allocate(16)
        .putLong(id.getMostSignificantBits())
        .putLong(id.getLeastSignificantBits())
        .array();
  }

  /** As RMI numbers methods. */
  private static long number(Method method) throws Exception {
    byte[] digest =
        java.security.MessageDigest.getInstance("SHA-1").digest(utf(method.getName() + "(I)I"));
    long number = 0;
    for (int i = 7; i >= 0; i--) {
      number = number << 8 | (digest[i] & 0xff);
    }
    return number;
  }

  private static byte[] utf(String text) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    new java.io.DataOutputStream(bytes).writeUTF(text);
    return bytes.toByteArray();
  }

  @Test
  void anOverlongOneIsRefusedBeforeItIsRead() throws Exception {
    bearer.carry((method, server) -> new byte[CallCredential.MAX_BYTES + 1]);
    assertThatThrownBy(() -> from(bearer).drive(3))
        .isInstanceOf(RemoteException.class)
        .hasStackTraceContaining("4097 bytes > 4096 allowed");
    byte[] answer = raw(bearer, new byte[0], 65_535);
    assertThat(new String(answer, StandardCharsets.ISO_8859_1))
        .contains("65535 bytes > 4096 allowed");
    assertThat(requests).isEmpty();
  }

  @Test
  void aServerOfPlainRiverRefusesTheCallCleanly() throws Exception {
    Uuid plainId = UuidFactory.generate();
    BasicJeriExporter plain =
        new BasicJeriExporter(
            RecordingServer.endpoint(team.of(MemberRole.ROBOT, "atrv2")),
            new BasicILFactory(),
            false,
            true,
            plainId);
    int plainPort = Objects.requireNonNull(PeerAddress.of(plain.export(impl))).port();
    try {
      Wheels wheels =
          CurrentIdentity.callAs(
              bearer,
              () ->
                  (Wheels)
                      DeadlineILFactory.proxy(
                          new BasicObjectEndpoint(
                              new TransportEndpoint(RecordingServer.HOST, plainPort),
                              plainId,
                              false),
                          Duration.ofSeconds(2),
                          getClass().getClassLoader(),
                          Wheels.class));
      assertThat(wheels.drive(1)).as("without a credential, River reads it").isEqualTo(1);
      byte[] usual = usual().bytes();
      bearer.carry((method, server) -> usual);
      assertThatThrownBy(() -> wheels.drive(2))
          .isInstanceOf(RemoteException.class)
          .hasRootCauseInstanceOf(NoSuchMethodException.class)
          .hasStackTraceContaining(UnmarshalException.class.getName());
      bearer.carry((method, server) -> null);
      assertThat(wheels.drive(4)).isEqualTo(4);
    } finally {
      plain.unexport(true);
    }
  }

  @Test
  void whatIsReadIsWhatWasSigned() throws Exception {
    Delegation made = usual();
    Delegation read = Delegation.parse(made.bytes(), "a file");
    assertThat(read).isEqualTo(made);
    assertThat(made.bytes().length).isLessThan(CallCredential.MAX_BYTES / 2);
    assertThat(read.principal()).isEqualTo(ANNA);
    for (int i = 0; i < made.bytes().length; i++) {
      byte[] changed = made.bytes();
      changed[i] ^= 1;
      assertThatThrownBy(() -> Delegation.parse(changed, "a file"))
          .as("byte %d", i)
          .isInstanceOf(org.dfra.river.identity.IdentityException.class);
    }
  }
}
