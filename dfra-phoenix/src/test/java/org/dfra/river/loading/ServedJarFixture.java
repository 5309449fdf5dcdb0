package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;
import org.assertj.core.api.AbstractThrowableAssert;
import org.dfra.river.fixture.SignerKey;
import org.dfra.river.fixture.TestCode;
import org.dfra.river.loading.CodeTrust.DownloadLimits;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** A lidar's jar, which a class server serves, and a key to sign it with. */
abstract class ServedJarFixture {

  static final String HOST = InetAddress.getLoopbackAddress().getHostAddress();
  static final String KIND = "sample.lidar.Lidar";
  static final String RAN = "sample.lidar.ran";

  @TempDir static Path keys;
  @TempDir static Path classes;
  static SignerKey team;

  @TempDir Path folder;
  Path jar;
  ClassServer server;

  @BeforeAll
  static void makeKey() throws Exception {
    team = SignerKey.create(keys, "team");
  }

  /** What each test packs into a jar of its own. */
  @BeforeAll
  static void compile() throws IOException {
    TestCode.compile(
        classes,
        Map.of(
            KIND,
            """
            package sample.lidar;
            public class Lidar implements java.io.Serializable {
              static { System.setProperty("sample.lidar.ran", "yes"); }
            }
            """,
            "sample.lidar.RemoteLidar",
            "package sample.lidar; public interface RemoteLidar extends java.rmi.Remote {}",
            "sample.lidar.Hidden",
            "package sample.lidar; interface Hidden extends java.rmi.Remote {}"));
    Files.writeString(classes.resolve("sample/lidar/name.txt"), "lidar");
  }

  @BeforeEach
  void build() throws IOException {
    System.clearProperty(RAN);
    jar = TestCode.jar(folder.resolve("lidar.jar"), classes);
  }

  @AfterEach
  void stop() {
    if (server != null) {
      server.close();
    }
  }

  /** The lidar is not loaded, for that reason, and none of its code has run. */
  static void assertRefused(VerifiedClassProvider provider, String codebase, String why) {
    for (int i = 0; i < 2; i++) { // the second time it is remembered
      AbstractThrowableAssert<?, ?> refusal =
          assertThatThrownBy(() -> load(provider, codebase))
              .isInstanceOf(ClassNotFoundException.class)
              .hasMessageStartingWith(KIND + " was not loaded: codebase ")
              .hasMessageContaining(why)
              .hasMessageContaining("; ")
              .hasCauseInstanceOf(CodeRefusedException.class);
      assertThat(refusal).isNotNull();
    }
    assertThat(System.getProperty(RAN)).isNull();
  }

  static Class<?> load(VerifiedClassProvider provider, String codebase)
      throws ClassNotFoundException {
    return provider.loadClass(codebase, KIND, null);
  }

  /** One that trusts a codebase's digest, and nothing else. */
  static VerifiedClassProvider pinning(String codebase) {
    return new VerifiedClassProvider(
        new CodeTrust(Set.of(), Set.of(digest(codebase)), DownloadLimits.DEFAULT));
  }

  /** One that trusts what a key has signed, and nothing else. */
  static VerifiedClassProvider trusting(SignerKey key) {
    return new VerifiedClassProvider(
        new CodeTrust(Set.of(key.certificate()), Set.of(), DownloadLimits.DEFAULT));
  }

  /** Serves the jar as it is now, until the test ends; its codebase. */
  String serve() throws IOException {
    server = new ClassServer(HOST, 0, folder, List.of("lidar.jar"));
    server.start();
    return server.codebase();
  }

  static String digest(String codebase) {
    return CodebaseUrl.parse(codebase).get(0).digest();
  }

  static int port(String codebase) {
    return CodebaseUrl.parse(codebase).get(0).location().getPort();
  }

  /** Adds an entry to the jar, which nobody signs. */
  void add(String name) throws IOException {
    rewrite(name, Files.readAllBytes(classes.resolve("sample/lidar/Lidar.class")));
  }

  /** Puts other content under a name, after all that the jar has. */
  void rewrite(String name, byte[] content) throws IOException {
    Path altered = folder.resolve("altered.jar");
    try (ZipInputStream in = new ZipInputStream(Files.newInputStream(jar));
        ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(altered))) {
      for (ZipEntry entry; (entry = in.getNextEntry()) != null; ) {
        if (!entry.getName().equals(name)) {
          out.putNextEntry(new ZipEntry(entry.getName()));
          in.transferTo(out);
        }
      }
      out.putNextEntry(new ZipEntry(name));
      out.write(content);
    }
    Files.move(altered, jar, java.nio.file.StandardCopyOption.REPLACE_EXISTING);
  }
}
