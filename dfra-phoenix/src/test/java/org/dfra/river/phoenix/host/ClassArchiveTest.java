package org.dfra.river.phoenix.host;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.core.host.PrivateFiles;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ClassArchiveTest {

  private static final Instant BUILT = Instant.parse("2026-11-28T12:00:00Z");

  @TempDir Path folder;
  private Path archives;
  private Path jar;
  private Path boot;

  @BeforeEach
  void prepare() throws IOException {
    archives = folder.resolve("archives");
    PrivateFiles.makeFolder(archives);
    System.setProperty(ClassArchive.COMMANDS, archives.resolve("17.0.1.jsa").toString());
    jar = jar("dfra-api.jar");
    boot = jar("dfra-activation.jar");
  }

  @AfterEach
  void forget() {
    System.clearProperty(ClassArchive.COMMANDS);
    ClassArchive.distrusted = false;
  }

  private Path jar(String name) throws IOException {
    Path made = Files.writeString(folder.resolve(name), "jar");
    Files.setLastModifiedTime(made, FileTime.from(BUILT));
    return made;
  }

  private List<String> options(Path... more) {
    StringBuilder path = new StringBuilder(jar.toString());
    for (Path each : more) {
      path.append(File.pathSeparator).append(each);
    }
    return List.of("-Xbootclasspath/a:" + boot, "-ea", "-cp", path.toString());
  }

  private Path file(Path... more) {
    return ClassArchive.of(options(more)).orElseThrow().file();
  }

  @Test
  void isBesideThatOfCommandsUnderANameOfItsJars() throws Exception {
    Path first = file();
    assertThat(first.getParent()).isEqualTo(archives);
    assertThat(first.getFileName().toString()).startsWith(ClassArchive.ROBOT);
    assertThat(file()).isEqualTo(first);
    assertThat(file(jar("more.jar"))).isNotEqualTo(first);

    Files.setLastModifiedTime(jar, FileTime.from(BUILT.plusSeconds(1)));
    Path second = file();
    assertThat(second).as("a jar of another time").isNotEqualTo(first);
    Files.writeString(boot, "another");
    Files.setLastModifiedTime(boot, FileTime.from(BUILT));
    assertThat(file()).as("another boot jar").isNotIn(first, second);
  }

  @Test
  void thereIsNoneWhereTheClassPathHasAFolder() throws Exception {
    assertThat(ClassArchive.of(options(Files.createDirectory(folder.resolve("classes")))))
        .isEmpty();
    assertThat(ClassArchive.of(options(folder.resolve("missing.jar"))))
        .as("what is missing is no folder")
        .isPresent();
    assertThat(ClassArchive.of(List.of("-ea"))).as("no class path").isEmpty();
  }

  @Test
  void thereIsNoneWhereNoFolderIsKnown() {
    System.clearProperty(ClassArchive.COMMANDS);
    assertThat(ClassArchive.of(options())).isEmpty();
  }

  /** A virtual machine refuses some of these options beside an archive. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "-Xshare:off",
        "-Xshare:auto",
        "-XX:SharedArchiveFile=/a.jsa",
        "-XX:ArchiveClassesAtExit=/a.jsa",
        "-XX:AOTCacheOutput=/a.aot"
      })
  void thereIsNoneForAProcessThatNamesItsOwn(String option) throws Exception {
    publish();
    List<String> options = new ArrayList<>(options());
    options.add(option);
    assertThat(ClassArchive.startOptions(options)).noneMatch(each -> each.contains("robot-"));
  }

  @Test
  void isUsedOnceItExists() throws Exception {
    Path file = file();
    assertThat(ClassArchive.startOptions(options()))
        .containsExactly("-XX:+UnlockDiagnosticVMOptions", "-XX:ArchiveRelocationMode=0");
    publish();
    assertThat(ClassArchive.startOptions(options()))
        .as("and nothing about it is printed")
        .anyMatch(each -> each.endsWith("=" + file))
        .contains("-Xlog:cds*=off");
  }

  private void publish() throws IOException {
    Path draft = Files.writeString(archives.resolve("draft"), "classes");
    ClassArchive.of(options()).orElseThrow().publish(draft);
    assertThat(draft).doesNotExist();
  }

  /** A virtual machine crashes where it expects a part that is not there. */
  @ParameterizedTest
  @ValueSource(strings = {"", "class", "classes of others", "glasses"})
  void isNotUsedUnlessItIsWhole(String content) throws Exception {
    publish();
    ClassArchive archive = ClassArchive.of(options()).orElseThrow();
    assertThat(archive.isUsable()).isTrue();
    Files.writeString(archive.file(), content);
    Files.setLastModifiedTime(archive.file(), FileTime.from(BUILT));
    assertThat(archive.isUsable()).isFalse();
    publish();
    assertThat(archive.isUsable()).isTrue();
    Files.delete(archive.file().resolveSibling(archive.file().getFileName() + ".seal"));
    Files.setLastModifiedTime(archive.file(), FileTime.from(BUILT));
    assertThat(archive.isUsable()).as("without its seal").isFalse();
  }

  @ParameterizedTest
  @ValueSource(strings = {"rwxrwx---", "rwx---rwx", "rwxr-xr-x"})
  void isNotUsedWhereOthersCouldHaveWrittenIt(String mode) throws Exception {
    publish();
    Files.setPosixFilePermissions(archives, PosixFilePermissions.fromString(mode));
    assertThat(ClassArchive.of(options()).orElseThrow().isUsable()).isFalse();
    assertThat(ClassArchive.startOptions(options())).noneMatch(each -> each.contains("robot-"));
  }

  @Test
  void isNotUsedAnyMoreAfterACrash() throws Exception {
    publish();
    for (int end : List.of(0, 1, 10, 137, 143)) {
      ClassArchive.recordExit(end);
    }
    assertThat(ClassArchive.of(options()).orElseThrow().isUsable()).as("no crash").isTrue();
    ClassArchive.recordExit(134);
    assertThat(ClassArchive.of(options()).orElseThrow().isUsable()).isFalse();
  }

  @Test
  void aFolderInItsPlaceIsNoArchive() throws Exception {
    Files.createDirectory(file());
    assertThat(ClassArchive.of(options()).orElseThrow().isUsable()).isFalse();
  }
}
