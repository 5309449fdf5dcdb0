package org.dfra.cli.security;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.SecurityFiles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What is read of a file that says that it is a bundle. */
class BundleTest {

  private static final byte[] CONTENT = {1, 2, 3};

  @TempDir Path folder;

  private Path bundle() {
    return folder.resolve("atrv1.bundle");
  }

  private void assertRefused(String... parts) {
    assertThatThrownBy(() -> Bundle.read(bundle()))
        .isInstanceOf(IdentityException.class)
        .hasMessageContainingAll(parts)
        .hasMessageContaining(bundle().toString())
        .hasMessageNotContaining("\n");
  }

  /** A zip with the files of every bundle, and others. */
  private byte[] zip(String... others) throws IOException {
    List<String> names = new ArrayList<>(List.of("identity.p12", "authority.pem", "revoked.crl"));
    names.addAll(List.of(others));
    return zip(names, CONTENT);
  }

  private static byte[] zip(List<String> names, byte[] content) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      for (String each : names) {
        zip.putNextEntry(new ZipEntry(each));
        zip.write(content);
        zip.closeEntry();
      }
    }
    return bytes.toByteArray();
  }

  @Test
  void whatIsWrittenIsRead() throws Exception {
    Bundle written =
        Bundle.of(
            Map.of("identity.p12", CONTENT, "authority.pem", CONTENT, "revoked.crl", CONTENT));
    Files.write(bundle(), written.toBytes());
    Bundle read = Bundle.read(bundle());
    assertThat(read.file("identity.p12")).contains(CONTENT);
    assertThat(read.file("robot.p12")).isEmpty();
    assertThat(read.file("../identity.p12")).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "../identity.p12",
        "/etc/passwd",
        "a/b",
        "..\\robot.p12",
        "jaas.conf",
        "identity.pass",
        "",
        "identity.p12/",
        "IDENTITY.P12"
      })
  void aFileThatNoBundleHasIsRefused(String name) throws Exception {
    Files.write(bundle(), zip(name));
    assertRefused("which no bundle has; ask for a new bundle");
  }

  @Test
  void nothingIsWrittenBesideIt() throws Exception {
    Files.write(bundle(), zip("../escaped"));
    assertRefused("\"../escaped\"");
    assertThat(folder.getParent().resolve("escaped")).doesNotExist();
    assertThat(folder).isDirectoryNotContaining(each -> !each.equals(bundle()));
  }

  /** Java's own writer of zips refuses that; other writers do not. */
  @Test
  void aFileThatIsThereTwiceIsRefused() throws Exception {
    byte[] zip = zip("identity.p13");
    replaceAll(zip, "identity.p13", "identity.p12");
    Files.write(bundle(), zip);
    assertRefused(" has identity.p12 twice");
  }

  private static void replaceAll(byte[] in, String from, String to) {
    byte[] old = from.getBytes();
    byte[] young = to.getBytes();
    for (int i = 0; i + old.length <= in.length; i++) {
      if (Arrays.equals(in, i, i + old.length, old, 0, old.length)) {
        System.arraycopy(young, 0, in, i, young.length);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"identity.p12", "authority.pem", "revoked.crl"})
  void aMissingFileIsNamed(String missing) throws Exception {
    List<String> names = new ArrayList<>(List.of("identity.p12", "authority.pem", "revoked.crl"));
    names.remove(missing);
    Files.write(bundle(), zip(names, CONTENT));
    assertRefused("since it has no " + missing);
  }

  @Test
  void aPolicyNeedsItsSignature() throws Exception {
    Files.write(bundle(), zip("policy.xml"));
    assertRefused("has only one of policy.xml and policy.sig");
  }

  @Test
  void aTruncatedBundleIsRefused() throws Exception {
    byte[] whole = zip("robot.p12");
    int ofFiles = new String(whole, java.nio.charset.StandardCharsets.ISO_8859_1).indexOf("PK\1\2");
    int refused = 0;
    for (int length = 0; length < ofFiles; length++) {
      Files.write(bundle(), Arrays.copyOf(whole, length));
      try {
        Bundle read = Bundle.read(bundle());
        assertThat(read.file("revoked.crl")).as("cut to %s bytes", length).contains(CONTENT);
      } catch (IdentityException e) {
        refused++;
      }
    }
    assertThat(refused).isGreaterThan(ofFiles / 2);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "no zip", "PK", "PK\3\4"})
  void bytesThatAreNoZipAreRefused(String text) throws Exception {
    Files.writeString(bundle(), text);
    assertRefused("bundle");
  }

  /** A bomb: 100 MB of zeros take 100 kB in a zip. */
  @Test
  void noMoreIsUnpackedThanAFileMayHave() throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      zip.putNextEntry(new ZipEntry("identity.p12"));
      byte[] zeros = new byte[1_000_000];
      for (int i = 0; i < 100; i++) {
        zip.write(zeros);
      }
      zip.closeEntry();
    }
    Files.write(bundle(), bytes.toByteArray());
    assertRefused(
        "its identity.p12 has more than " + SecurityFiles.maxBytes("identity.p12") + " bytes");
  }

  @Test
  void aLargeFileIsNotRead() throws Exception {
    Files.write(bundle(), new byte[6 * 1024 * 1024 + 1]);
    assertRefused("has more than 6291456 bytes, so it is no bundle");
  }

  @Test
  void aMissingFileAndAFolderAreNamed() throws Exception {
    assertRefused("there is no file");
    Files.createDirectory(bundle());
    assertRefused("cannot be read");
  }
}
