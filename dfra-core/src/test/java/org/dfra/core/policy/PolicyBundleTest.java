package org.dfra.core.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.GeneralSecurityException;
import java.util.Random;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Only policies that the authority has signed are stored, and none that is older. */
class PolicyBundleTest {

  @TempDir static Path keys;

  private static TestAuthority authority;
  private static TestAuthority other;

  @TempDir Path temp;
  private Path folder;
  private PolicyStore store;

  @BeforeAll
  static void makeKeys() throws Exception {
    authority = TestAuthority.create(keys, "authority", "EC");
    other = TestAuthority.create(keys, "other", "EC");
  }

  @BeforeEach
  void openStore() {
    folder = temp.resolve("security");
    store = new PolicyStore(folder, authority.certificate(), InterfaceCatalogue.builtIn());
  }

  private static byte[] text(long version, String... lines) {
    return PolicyFixture.xml(version, lines).getBytes(StandardCharsets.UTF_8);
  }

  private static PolicyBundle signed(long version, String... lines)
      throws GeneralSecurityException {
    return PolicyBundle.sign(text(version, lines), authority.key());
  }

  @Test
  void anySingleChangedBitIsRefused() throws Exception {
    PolicyBundle right = signed(1, "<permit role=\"operator\"/>");
    right.verify(authority.certificate());
    Random random = new Random(2004);
    for (int i = 0; i < 200; i++) {
      byte[] policy = right.policy();
      policy[random.nextInt(policy.length)] ^= (byte) (1 << random.nextInt(8));
      assertRefused(PolicyBundle.of(policy, right.signature()));
      byte[] signature = right.signature();
      int at = random.nextInt(signature.length - 1); // without the end of its line
      signature[at] ^= 1;
      assertRefused(PolicyBundle.of(right.policy(), signature));
    }
    assertRefused(PolicyBundle.of(right.policy(), new byte[0]));
    assertRefused(
        PolicyBundle.of(right.policy(), "A".repeat(100_000).getBytes(StandardCharsets.US_ASCII)));
  }

  private static void assertRefused(PolicyBundle bundle) {
    assertThatThrownBy(() -> bundle.verify(authority.certificate()))
        .isInstanceOf(PolicySignatureException.class);
  }

  @Test
  void theSignatureOfAnotherAuthorityIsRefused() throws Exception {
    PolicyBundle foreign = PolicyBundle.sign(text(1, "<permit/>"), other.key());
    assertThatThrownBy(() -> foreign.verify(authority.certificate()))
        .isInstanceOf(PolicySignatureException.class)
        .hasMessageContaining("is not that of CN=authority,O=field for these bytes");
    assertThatThrownBy(() -> store.store(foreign)).isInstanceOf(PolicySignatureException.class);
    assertThat(store.load()).isEmpty();
  }

  @Test
  void aCertificateWithAnotherKindOfKeyIsRefused() throws Exception {
    TestAuthority rsa = TestAuthority.create(temp, "rsa", "RSA");
    assertThatThrownBy(() -> signed(1, "<permit/>").verify(rsa.certificate()))
        .hasMessageContaining("the key of CN=rsa,O=field is of RSA and signs no policy");
  }

  @Test
  void storesAPolicyAndOnlyANewerOneAfterIt() throws Exception {
    assertThat(store.load()).isEmpty();
    store.store(signed(7, "<permit/>"));
    store.store(signed(7, "<permit/>"));
    assertThat(store.load().orElseThrow().version()).isEqualTo(7);
    assertThatThrownBy(() -> store.store(signed(6, "<permit/>")))
        .isInstanceOf(PolicyReplacementException.class)
        .hasMessageContaining("the policy has version 6");
    assertThatThrownBy(() -> store.store(signed(7, "<deny/>")))
        .isInstanceOf(PolicyReplacementException.class);
    assertThatThrownBy(() -> store.store(signed(9, "<permit rol=\"x\"/>")))
        .isInstanceOf(ConfigurationException.class);
    assertThat(store.load().orElseThrow().version()).isEqualTo(7);
    store.store(signed(8, "<deny/>"));
    assertThat(store.load().orElseThrow().version()).isEqualTo(8);
    assertThat(
            PosixFilePermissions.toString(
                Files.getPosixFilePermissions(folder.resolve(PolicyStore.POLICY))))
        .isEqualTo("rw-------");
  }

  /** A crash may come before, between and after the two renamings. */
  @Test
  void aCrashLeavesTheOldOrTheNewPolicy() throws Exception {
    store.store(signed(1, "<permit/>"));
    PolicyBundle next = signed(2, "<deny/>");
    Files.write(folder.resolve("policy.xml.new"), next.policy());
    Files.write(folder.resolve("policy.sig.new"), next.signature());
    assertThat(store.load().orElseThrow().version()).as("before the first").isEqualTo(1);

    Files.write(folder.resolve("policy.sig"), next.signature());
    assertThat(store.load().orElseThrow().version()).as("after the first").isEqualTo(2);
    assertThat(store.load().orElseThrow().version()).isEqualTo(2);
    store.store(signed(3, "<permit/>"));
    assertThat(store.load().orElseThrow().version()).isEqualTo(3);
  }

  @Test
  void aStoredPolicyThatWasChangedIsRefused() throws Exception {
    store.store(signed(1, "<deny/>"));
    Files.write(folder.resolve("policy.xml"), text(1, "<permit/>"));
    assertThatThrownBy(() -> store.load()).isInstanceOf(PolicySignatureException.class);
    Files.delete(folder.resolve("policy.sig"));
    assertThatThrownBy(() -> store.load())
        .isInstanceOf(PolicySignatureException.class)
        .hasMessageContaining("policy.xml without policy.sig; copy both from the authority");
  }

  /** A robot that lacks an interface of the stored policy can still get the next policy. */
  @Test
  void aStoredPolicyWithFaultsIsReplacedByANewerOne() throws Exception {
    InterfaceCatalogue with = InterfaceCatalogue.parse("a.Lamp\n\ton\tread\tx\n");
    new PolicyStore(folder, authority.certificate(), with)
        .store(signed(4, "<permit interface=\"a.Lamp\"/>"));
    assertThatThrownBy(() -> store.load()).isInstanceOf(ConfigurationException.class);
    assertThatThrownBy(() -> store.store(signed(3, "<permit/>")))
        .isInstanceOf(PolicyReplacementException.class);
    store.store(signed(5, "<permit/>"));
    assertThat(store.load().orElseThrow().version()).isEqualTo(5);
  }

  /**
   * The note is believed for exactly the text that it is about, so that a process which starts need
   * not compile the schema. The text here breaks the schema alone, which nobody would sign.
   */
  @Test
  void aPolicyIsValidatedOnceAndAgainWhenItHasChanged() throws Exception {
    store.store(signed(1, "<permit/>"));
    Path note = folder.resolve(PolicyStore.VALID);
    assertThat(note).doesNotExist();
    store.load();
    assertThat(Files.readString(note)).isEqualTo(PolicyXml.checksum(text(1, "<permit/>")));
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(note)))
        .isEqualTo("rw-------");

    PolicyBundle broken = signed(2, "<permit unknown=\"x\"/>");
    Files.write(folder.resolve("policy.xml"), broken.policy());
    Files.write(folder.resolve("policy.sig"), broken.signature());
    assertThatThrownBy(() -> store.load()).isInstanceOf(ConfigurationException.class);
    Files.writeString(note, PolicyXml.checksum(broken.policy()));
    assertThat(store.load().orElseThrow().version()).as("not validated again").isEqualTo(2);

    Files.write(folder.resolve("policy.sig"), signed(2, "<permit/>").signature());
    assertThatThrownBy(() -> store.load())
        .as("the note replaces no signature")
        .isInstanceOf(PolicySignatureException.class);
  }
}
