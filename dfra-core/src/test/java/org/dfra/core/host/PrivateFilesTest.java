package org.dfra.core.host;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Files and folders that other users cannot reach. */
class PrivateFilesTest {

  @TempDir Path temp;

  @Test
  void foldersAreMadePrivateWithAllAboveThem() throws Exception {
    Path folder = temp.resolve("a/b");
    PrivateFiles.requireFolder(folder);
    assertThat(mode(folder)).isEqualTo("rwx------");
    assertThat(mode(folder.getParent())).isEqualTo("rwx------");
    assertThatCode(() -> PrivateFiles.requireFolder(folder)).doesNotThrowAnyException();
  }

  @ParameterizedTest
  @ValueSource(strings = {"rwxr-xr-x", "rwx--x--x", "rwxrwx---", "rwx---r--"})
  void folderThatOthersMayUseIsRefusedWithTheCommandThatMendsIt(String mode) throws Exception {
    Path folder = Files.createDirectory(temp.resolve("it's open"));
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString(mode));
    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> PrivateFiles.requireFolder(folder))
        .withMessage(
            "other users may enter the folder %s (%s), which must be private; type: chmod 700 '%s'",
            folder, mode, folder.toString().replace("'", "'\\''"));
    assertThat(mode(folder)).as("it is not changed").isEqualTo(mode);
    assertThatCode(() -> PrivateFiles.requireFolderOrParent(folder))
        .as("it is in a private one")
        .doesNotThrowAnyException();
  }

  @Test
  void linkToAPrivateFolderIsOne() throws Exception {
    Path folder = Files.createDirectory(temp.resolve("folder"));
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwx------"));
    Path link = Files.createSymbolicLink(temp.resolve("link"), folder);
    assertThatCode(() -> PrivateFiles.requireFolder(link)).doesNotThrowAnyException();
  }

  @Test
  void filesAreMadePrivateAndNotTwice() throws Exception {
    Path file = temp.resolve("file");
    PrivateFiles.makeFile(file);
    assertThat(mode(file)).isEqualTo("rw-------");
    Files.writeString(file, "kept");
    PrivateFiles.makeFile(file);
    assertThat(PrivateFiles.writeNew(file, "other")).isFalse();
    assertThat(file).hasContent("kept");

    Path whole = temp.resolve("whole");
    assertThat(PrivateFiles.writeNew(whole, "text")).isTrue();
    assertThat(whole).hasContent("text");
    assertThat(mode(whole)).isEqualTo("rw-------");
    try (var files = Files.list(temp)) {
      assertThat(files).as("no draft is left").hasSize(2);
    }
  }

  @Test
  void filesAreReplacedWhole() throws Exception {
    Path file = temp.resolve("file");
    PrivateFiles.write(file, new byte[] {1, 2, 3});
    PrivateFiles.write(file, new byte[] {4});
    assertThat(file).hasBinaryContent(new byte[] {4});
    assertThat(mode(file)).isEqualTo("rw-------");
    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> PrivateFiles.write(temp.resolve("missing/file"), new byte[0]));
    try (var files = Files.list(temp)) {
      assertThat(files).as("no draft is left").containsExactly(file);
    }
  }

  @Test
  void fileThatOthersMayUseIsRefused() throws Exception {
    Path file = Files.createFile(temp.resolve("file"));
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r--r--"));
    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> PrivateFiles.requireFile(file))
        .withMessageContaining("type: chmod 600 " + file);
    PrivateFiles.closeToOthers(file);
    assertThatCode(() -> PrivateFiles.requireFile(file)).doesNotThrowAnyException();
  }

  @Test
  void ownerIsThatOfTheNearestPathThatIsSeen() throws Exception {
    assertThat(PrivateFiles.ownerName(temp.resolve("not/there")))
        .isEqualTo(PrivateFiles.user().getName());
  }

  private static String mode(Path path) throws IOException {
    return PosixFilePermissions.toString(Files.getPosixFilePermissions(path));
  }
}
