package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Map;
import org.dfra.river.loading.CodeTrust.DownloadLimits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class JarStoreTest {

  @TempDir private Path folder;

  private static byte[] jar(int number) {
    return ("jar " + number).getBytes(StandardCharsets.UTF_8);
  }

  @Test
  void findsByDigestWhatWasKept() throws IOException {
    JarStore kept = new JarStore(folder.resolve("a/b"));
    String digest = Digests.sha256(jar(1));
    assertThat(kept.find(digest)).isNull();
    kept.put(jar(1), digest);
    kept.put(jar(1), digest);
    assertThat(kept.find(digest)).isEqualTo(jar(1));

    Files.write(folder.resolve("a/b/" + digest + ".jar"), jar(2));
    assertThat(kept.find(digest)).as("damaged").isNull();
  }

  @Test
  void forgetsTheOldestFirst() throws IOException {
    JarStore kept = new JarStore(folder);
    for (int i = 0; i < JarStore.MAX_JARS + 3; i++) {
      String digest = Digests.sha256(jar(i));
      kept.put(jar(i), digest);
      Files.setLastModifiedTime(folder.resolve(digest + ".jar"), FileTime.fromMillis(i * 1000L));
    }
    kept.put(jar(3), Digests.sha256(jar(3))); // named again, so it is the newest
    kept.put(jar(999), Digests.sha256(jar(999)));
    assertThat(kept.find(Digests.sha256(jar(2)))).isNull();
    assertThat(kept.find(Digests.sha256(jar(3)))).isNotNull();
    try (var files = Files.list(folder)) {
      assertThat(files).hasSize(JarStore.MAX_JARS);
    }
  }

  @Test
  void saysThatItsFolderCannotBeWritten() throws IOException {
    Path file = Files.createFile(folder.resolve("file"));
    assertThatThrownBy(() -> new JarStore(file).put(jar(1), Digests.sha256(jar(1))))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith("the folder " + file + " cannot keep a jar (")
        .hasMessageEndingWith("; make it writable");
  }

  @Test
  void aClassServerHasWhatTheOthersNamedBeforeOrAfterIt() throws Exception {
    JarStore kept = new JarStore(folder.resolve("kept"));
    Path file = Files.write(folder.resolve("a.jar"), jar(1));
    kept.put(jar(0), Digests.sha256(jar(0)));
    try (ClassServer server = new ClassServer("127.0.0.1", 0, Map.of("a.jar", file), kept)) {
      server.start();
      kept.put(jar(2), Digests.sha256(jar(2)));
      for (int i : List.of(0, 1, 2)) {
        String url = ClassServer.url("127.0.0.1", server.port(), "a.jar", Digests.sha256(jar(i)));
        CodebaseUrl parsed = CodebaseUrl.parse(url).get(0);
        assertThat(new JarDownload(DownloadLimits.DEFAULT).fetch(parsed)).isEqualTo(jar(i));
      }
    }
  }

  /** As clients do whose annotations are from a release that named its jar differently. */
  @Test
  void aClassServerHasAFormerJarUnderANameThatNoJarHasNow() throws Exception {
    JarStore kept = new JarStore(folder.resolve("kept"));
    Path file = Files.write(folder.resolve("new.jar"), jar(1));
    kept.put(jar(0), Digests.sha256(jar(0)));
    try (ClassServer server = new ClassServer("127.0.0.1", 0, Map.of("new.jar", file), kept)) {
      server.start();
      String url = ClassServer.url("127.0.0.1", server.port(), "old.jar", Digests.sha256(jar(0)));
      CodebaseUrl parsed = CodebaseUrl.parse(url).get(0);
      assertThat(new JarDownload(DownloadLimits.DEFAULT).fetch(parsed)).isEqualTo(jar(0));
    }
  }
}
