package org.dfra.cli.archive;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.PrivateKey;
import java.security.SecureRandom;
import java.security.Signature;
import java.security.cert.X509Certificate;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dfra.core.host.PrivateFiles;
import org.dfra.core.policy.BuiltInPolicies;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.KeyEntry;
import org.dfra.river.identity.SecurityFiles;

/**
 * The identity of a robot that exists only while an archive is written: so the archive has what a
 * member's process loads too. Its authority is made for it alone, its keys stay in a temporary
 * folder, and nobody else believes it.
 *
 * <p>The JDK's {@code keytool} makes the certificates, since robots do not have the library of the
 * authority's tool.
 */
final class ArchiveIdentity {

  /** Name of the robot and of its team. */
  static final String NAME = "archive";

  private static final String AUTHORITY = "authority";
  private static final String SIGNATURE = "SHA256withECDSA";
  private static final int PASSPHRASE_BYTES = 16;
  private static final long TIME_LIMIT_SECONDS = 60;

  private final Path work;
  private final Path store;
  private final Path passphraseFile;
  private final String passphrase;

  private ArchiveIdentity(Path work) {
    this.work = work;
    this.store = work.resolve("all.p12");
    this.passphraseFile = work.resolve("all.pass");
    byte[] random = new byte[PASSPHRASE_BYTES];
    new SecureRandom().nextBytes(random);
    this.passphrase = HexFormat.of().formatHex(random);
  }

  /**
   * Makes the identity.
   *
   * @param work a private folder for intermediate files
   * @param folder to make: {@code security} in the robot's state folder
   * @throws IOException if this Java has no {@code keytool}, or it fails
   */
  static void create(Path work, Path folder) throws IOException, InterruptedException {
    new ArchiveIdentity(work).write(folder);
  }

  private void write(Path folder) throws IOException, InterruptedException {
    PrivateFiles.write(passphraseFile, passphrase.getBytes(StandardCharsets.US_ASCII));
    makeKey(
        AUTHORITY, "CN=archive authority, O=archive", "bc:c=ca:true", "ku:c=keyCertSign,cRLSign");
    makeKey(
        SecurityFiles.IDENTITY_ALIAS,
        "CN=archive, OU=robot, O=archive",
        "ku:c=digitalSignature",
        "eku=serverAuth,clientAuth");
    makeKey(SecurityFiles.ROBOT_ALIAS, "CN=archive robot key", "ku:c=digitalSignature");
    PrivateFiles.makeFolder(folder);
    try {
      KeyEntry authority = read(AUTHORITY);
      X509Certificate certificate = authority.chain().get(0);
      write(folder, SecurityFiles.AUTHORITY, pem(certificate.getEncoded()));
      String policy = BuiltInPolicies.standardText(NAME, 1);
      write(folder, SecurityFiles.POLICY, policy);
      write(folder, SecurityFiles.POLICY_SIGNATURE, signature(policy, authority.key()));
      writeKey(
          folder,
          SecurityFiles.IDENTITY_ALIAS,
          SecurityFiles.IDENTITY,
          SecurityFiles.IDENTITY_PASSPHRASE);
      writeKey(
          folder, SecurityFiles.ROBOT_ALIAS, SecurityFiles.ROBOT, SecurityFiles.ROBOT_PASSPHRASE);
    } catch (GeneralSecurityException | IdentityException e) {
      throw new IOException(e);
    } finally {
      Files.deleteIfExists(store);
    }
  }

  /** Makes a key with a certificate; that of the member is from the authority. */
  private void makeKey(String alias, String subject, String... extensions)
      throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "keytool").toString(),
                "-J-XX:TieredStopAtLevel=1",
                "-genkeypair",
                "-keystore",
                store.toString(),
                "-storetype",
                "PKCS12",
                "-storepass:file",
                passphraseFile.toString(),
                "-alias",
                alias,
                "-keyalg",
                "EC",
                "-groupname",
                "secp256r1",
                "-sigalg",
                SIGNATURE,
                "-dname",
                subject,
                "-startdate",
                "-1d",
                "-validity",
                "30"));
    for (String each : extensions) {
      command.addAll(List.of("-ext", each));
    }
    if (alias.equals(SecurityFiles.IDENTITY_ALIAS)) {
      command.addAll(List.of("-signer", AUTHORITY));
    }
    Process process =
        new ProcessBuilder(command)
            .directory(work.toFile())
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    process.getOutputStream().close();
    if (!process.waitFor(TIME_LIMIT_SECONDS, TimeUnit.SECONDS)) {
      process.destroyForcibly();
      throw new IOException(command.get(0) + " did not end in " + TIME_LIMIT_SECONDS + " s");
    }
    if (process.exitValue() != 0) {
      throw new IOException(command.get(0) + " ended with exit code " + process.exitValue());
    }
  }

  private KeyEntry read(String alias) throws IOException, IdentityException {
    return KeyEntry.read(
        Files.readAllBytes(store), passphrase.toCharArray(), alias, store.toString());
  }

  private void writeKey(Path folder, String alias, String file, String opens)
      throws IOException, IdentityException {
    PrivateFiles.write(
        folder.resolve(file), read(alias).toKeyStoreOfRandom(alias, passphrase.toCharArray()));
    write(folder, opens, passphrase + "\n");
  }

  private static void write(Path folder, String name, String content) throws IOException {
    PrivateFiles.write(folder.resolve(name), content.getBytes(StandardCharsets.UTF_8));
  }

  private static String pem(byte[] certificate) {
    return "-----BEGIN CERTIFICATE-----\n"
        + Base64.getMimeEncoder().encodeToString(certificate)
        + "\n-----END CERTIFICATE-----\n";
  }

  private static String signature(String policy, PrivateKey key) throws GeneralSecurityException {
    Signature signer = Signature.getInstance(SIGNATURE);
    signer.initSign(key);
    signer.update(policy.getBytes(StandardCharsets.UTF_8));
    return Base64.getEncoder().encodeToString(signer.sign());
  }
}
