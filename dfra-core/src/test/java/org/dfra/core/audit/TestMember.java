package org.dfra.core.audit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.cert.X509Certificate;
import java.util.List;

/** A member with a key, whose certificate it has signed itself. */
record TestMember(PrivateKey key, X509Certificate certificate) {

  private static final char[] PASSPHRASE = "of-a-test".toCharArray();

  /** The JDK's own tool makes it, since its API has no way to. */
  static TestMember create(Path folder, String role, String name) throws Exception {
    Path store = folder.resolve(name + ".p12");
    Path output = folder.resolve(name + ".keytool");
    Process keytool =
        new ProcessBuilder(
                List.of(
                    Path.of(System.getProperty("java.home"), "bin", "keytool").toString(),
                    "-J-XX:TieredStopAtLevel=1",
                    "-J-XX:+UseSerialGC",
                    "-genkeypair",
                    "-alias",
                    "member",
                    "-keyalg",
                    "EC",
                    "-groupname",
                    "secp256r1",
                    "-dname",
                    "CN=" + name + ", OU=" + role + ", O=field",
                    "-storetype",
                    "PKCS12",
                    "-keystore",
                    store.toString(),
                    "-storepass",
                    new String(PASSPHRASE)))
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    assertThat(keytool.waitFor()).as(Files.readString(output)).isZero();
    KeyStore keys = KeyStore.getInstance("PKCS12");
    try (InputStream in = Files.newInputStream(store)) {
      keys.load(in, PASSPHRASE);
    }
    return new TestMember(
        (PrivateKey) keys.getKey("member", PASSPHRASE),
        (X509Certificate) keys.getCertificate("member"));
  }
}
