package org.dfra.river.security.news;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.GeneralSecurityException;
import java.time.Clock;
import java.time.Duration;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import org.dfra.core.audit.AuditEvent;
import org.dfra.core.audit.AuditHead;
import org.dfra.core.audit.AuditSettings;
import org.dfra.core.audit.AuditTrail;
import org.dfra.core.audit.AuditVerifier;
import org.dfra.core.audit.HeadStore;
import org.dfra.core.audit.KeptHead;
import org.dfra.core.audit.VerifiedStream;
import org.dfra.core.audit.VerifiedStream.Break;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.fixture.TestTeam.Issued;
import org.dfra.river.identity.RevokedCertificates;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.SignedFiles;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.river.security.news.TeamNews.Numbers;
import org.dfra.river.security.news.TeamNews.SignedHead;
import org.dfra.river.security.news.TeamNews.SignedHeads;
import org.dfra.security.Decision;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two processes of a team, each with a folder of its own, that call each other directly. */
class NewsExchangeTest {

  private static final TestTeam TEAM = new TestTeam("field");
  private static final Issued FIRST = TEAM.issue(new Member("field", MemberRole.ROBOT, "atrv1"));
  private static final Issued SECOND = TEAM.issue(new Member("field", MemberRole.ROBOT, "atrv2"));
  private static final InstantSource CLOCK = InstantSource.system();
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  @TempDir private Path folders;

  private Path here;
  private Path there;
  private NewsExchange exchange;
  private TeamNews other;
  private HeadFiles otherHeads;
  private final List<Numbers> takenHere = new ArrayList<>();
  private final List<Numbers> takenThere = new ArrayList<>();

  @BeforeEach
  void join() throws Exception {
    here = folder("here");
    there = folder("there");
    exchange =
        new NewsExchange(
            here,
            TEAM.authority(),
            identity(FIRST),
            () -> numbers(here),
            () -> takenHere.add(numbers(here)));
    otherHeads = new HeadFiles(stateOf(there), identity(SECOND), CLOCK);
    other =
        new NewsService(
            new NewsFiles(there, TEAM.authority(), () -> takenThere.add(numbers(there))),
            otherHeads,
            () -> numbers(there));
  }

  private static TeamIdentity identity(Issued issued) throws GeneralSecurityException {
    return new TeamIdentity(
        new TeamIdentity.Settings(
            Member.of(issued.certificate().getSubjectX500Principal()),
            new TeamIdentity.Key(issued.key(), List.of(issued.certificate())),
            Set.of(),
            Set.of(),
            TEAM.authority(),
            new RevokedCertificates(TEAM.authority()),
            request -> Decision.permit("test"),
            false),
        Clock.systemUTC());
  }

  private static Path stateOf(Path security) {
    return security.getParent();
  }

  private Path folder(String name) throws IOException {
    return Files.createDirectory(
        Files.createDirectory(folders.resolve(name)).resolve("security"),
        PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
  }

  private static Path list(Path folder) {
    return folder.resolve(SecurityFiles.REVOKED);
  }

  private static Numbers numbers(Path folder) {
    try {
      long number =
          Files.exists(list(folder))
              ? SignedFiles.number(
                      SignedFiles.revocations(
                          Files.readAllBytes(list(folder)), TEAM.authority(), "list"))
                  .orElseThrow()
                  .longValue()
              : 0;
      return new Numbers(number, 0);
    } catch (Exception e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void theOneWithTheOlderListTakesTheNewerOne() throws IOException {
    Files.write(list(here), TEAM.revocations(3));
    assertThat(exchange.exchange(other)).isEqualTo(new Numbers(3, 0));
    assertThat(list(there)).hasSameBinaryContentAs(list(here));

    Files.write(list(there), TEAM.revocations(5));
    assertThat(exchange.exchange(other)).isEqualTo(new Numbers(5, 0));
    assertThat(list(here)).hasSameBinaryContentAs(list(there));
    assertThat(takenThere).as("put in force at once").containsExactly(new Numbers(3, 0));
    assertThat(takenHere).containsExactly(new Numbers(5, 0));
    Numbers same = exchange.exchange(other);
    assertThat(same).isEqualTo(new Numbers(5, 0));
    assertThat(takenThere).as("nothing new").hasSize(1);
    assertThat(takenHere).hasSize(1);
  }

  @Test
  void nothingOlderOrForgedIsTaken() throws IOException {
    byte[] fourth = TEAM.revocations(4);
    other.takeRevocations(fourth);
    other.takeRevocations(TEAM.revocations(2));
    assertThat(list(there)).hasBinaryContent(fourth);
    assertThatThrownBy(() -> other.takeRevocations(new TestTeam("field").revocations(9)))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(
            "the list of revoked certificates that was offered is not signed by the authority");
    assertThatThrownBy(() -> other.takeRevocations(new byte[100]))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("is no list of revoked certificates");
    assertThatThrownBy(() -> other.takeRevocations(new byte[64 << 20]))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("67108864 bytes");
    assertThat(list(there)).hasBinaryContent(fourth);
  }

  @Test
  void aListThatIsMissingIsReported() {
    assertThatThrownBy(other::revocations).isInstanceOf(IOException.class);
    assertThatThrownBy(other::policy).isInstanceOf(IOException.class);
  }

  /** The end of a trail that really is there. */
  private KeptHead head(Path state, Issued owner, int records) throws Exception {
    Member member = Member.of(owner.certificate().getSubjectX500Principal());
    try (AuditTrail trail =
        new AuditTrail(
            AuditSettings.of(AuditSettings.folder(state), "gps", member.toString()), CLOCK)) {
      trail.start();
      for (int i = 0; i < records; i++) {
        trail.record(AuditEvent.policyReplaced(i, "policy.xml"));
      }
      return KeptHead.of(trail.head(owner.key(), PATIENCE), owner.certificate());
    }
  }

  @Test
  void bothKeepTheEndsOfTheOthersTrails() throws Exception {
    KeptHead first = head(stateOf(here), FIRST, 3);
    KeptHead second = head(stateOf(there), SECOND, 5);
    HeadFiles own = new HeadFiles(stateOf(here), identity(FIRST), CLOCK);
    own.writeOwn(first);
    otherHeads.writeOwn(second);
    exchange.exchangeHeads(other);
    assertThat(otherHeads.kept("robot atrv1 of field")).containsExactly(first);
    assertThat(own.kept("robot atrv2 of field")).containsExactly(second);
    assertThat(own.isRecent("robot atrv2 of field", NewsExchange.HEADS_PERIOD)).isTrue();
    assertThat(own.isRecent("robot atrv3 of field", NewsExchange.HEADS_PERIOD)).isFalse();
    assertThat(HeadStore.parse(other.keptHeads("robot atrv1 of field"), "wire"))
        .containsExactly(first);
    assertThat(other.keptHeads("robot atrv3 of field")).isEmpty();

    List<VerifiedStream> whole =
        AuditVerifier.verify(
            AuditSettings.folder(stateOf(here)), otherHeads.kept("robot atrv1 of field"));
    assertThat(whole).allMatch(each -> each.broken().isEmpty());
    Path trail = AuditSettings.folder(stateOf(here)).resolve("gps.000001.jsonl");
    List<String> lines = Files.readAllLines(trail);
    Files.write(trail, lines.subList(0, 2));
    assertThat(
            AuditVerifier.verify(
                    AuditSettings.folder(stateOf(here)), otherHeads.kept("robot atrv1 of field"))
                .get(0)
                .broken()
                .orElseThrow()
                .toString())
        .startsWith(
            trail + ":2: the stream was cut after line 2: robot atrv1 of field signed number ");
  }

  @Test
  void twoSignedLinesWithOneNumberAreAFork() throws Exception {
    KeptHead first = head(stateOf(here), FIRST, 3);
    HeadFiles own = new HeadFiles(stateOf(here), identity(FIRST), CLOCK);
    own.writeOwn(first);
    otherHeads.take(own.own());
    Files.delete(AuditSettings.folder(stateOf(here)).resolve("gps.000001.jsonl"));
    Files.delete(stateOf(here).resolve("heads/own/gps.jsonl"));
    KeptHead again = head(stateOf(here), FIRST, 3);
    assertThat(again.head().number()).isEqualTo(first.head().number());
    own.writeOwn(again);
    otherHeads.take(own.own());
    assertThat(otherHeads.kept("robot atrv1 of field")).containsExactly(first, again);
    Break broken =
        AuditVerifier.verify(
                AuditSettings.folder(stateOf(here)), otherHeads.kept("robot atrv1 of field"))
            .get(0)
            .broken()
            .orElseThrow();
    assertThat(broken.kind()).isEqualTo(VerifiedStream.Kind.FORKED);
    assertThat(broken.toString())
        .contains(
            "gps.000001.jsonl:" + first.head().number() + ": the trail was written twice",
            "another one with this number");
  }

  @Test
  void hostileHeadsAreRefused() throws Exception {
    KeptHead good = head(stateOf(here), FIRST, 1);
    byte[] certificate = FIRST.certificate().getEncoded();
    SignedHead head = signed(good.head().stream(), good.head().number(), good.head());
    Issued others = new TestTeam("field").issue(new Member("field", MemberRole.ROBOT, "atrv1"));
    Issued otherTeam = TEAM.issue(new Member("other", MemberRole.ROBOT, "atrv1"));
    assertRefused(others.certificate().getEncoded(), List.of(head), "is not of");
    assertRefused(otherTeam.certificate().getEncoded(), List.of(head), "is of another team");
    assertRefused(SECOND.certificate().getEncoded(), List.of(head), "has not signed the head");
    assertRefused(new byte[100_000], List.of(head), "a certificate of 100000 bytes was offered");
    assertRefused(new byte[10], List.of(head), "the heads of audit trails are refused");
    assertRefused(
        certificate, Collections.nCopies(10_000, head), "10000 heads of audit trails were offered");
    assertRefused(
        certificate, List.of(signed("gps", good.head().number() + 1, good.head())), "not signed");
    assertRefused(
        certificate, List.of(signed("../x", 1, good.head())), "no head of an audit trail");
    assertRefused(
        certificate, List.of(signed("gps", -1, good.head())), "no head of an audit trail");
    assertThat(otherHeads.kept("robot atrv1 of field")).isEmpty();
    otherHeads.take(new SignedHeads(certificate, List.of(head)));
    otherHeads.take(new SignedHeads(certificate, List.of(head))); // again
    assertThat(otherHeads.kept("robot atrv1 of field")).containsExactly(good);
  }

  private static SignedHead signed(String stream, long number, AuditHead like) {
    return new SignedHead(
        stream, number, like.hash(), like.time().toEpochMilli(), like.signature());
  }

  private void assertRefused(byte[] certificate, List<SignedHead> heads, String why) {
    assertThatThrownBy(() -> other.exchangeHeads(new SignedHeads(certificate, heads)))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(why);
  }
}
