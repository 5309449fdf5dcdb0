package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.abort;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The repository holds sources only, and each package says what it is for. */
class RepositoryTest {

  private static final Pattern BINARY_NAME =
      Pattern.compile(
          "(?i).*\\.(jar|war|ear|class|jmod|zip|tar|t?gz|so|dll|dylib|exe|o|a|jks|p12|keystore)");

  /**
   * The first bytes of: class files, zip and jar files, ELF, gzip, Windows programs' "MZ" followed
   * by 0x90.
   */
  private static final List<String> BINARY_BEGINNINGS =
      List.of("cafebabe", "504b0304", "7f454c46", "1f8b08", "4d5a90");

  /** Also removes the end of a line with an address in a literal, in which no command stands. */
  private static final Pattern COMMENT = Pattern.compile("(?s)/\\*.*?\\*/|//[^\n]*");

  private static final Pattern COMMAND_IN_CHECKOUT = Pattern.compile("\\./dfra(?![\\w/-])");

  @TempDir Path elsewhere;

  @Test
  void holdsNoBinary() throws IOException, InterruptedException {
    Path root = Repository.root();
    assumeTrue(
        Files.exists(root.resolve(".git")),
        "this is no git checkout, so no list of what the repository holds");
    List<Path> files = gitFiles(root);
    assertThat(files).as("git ls-files").contains(root.resolve("pom.xml"));
    assertThat(files.stream().filter(RepositoryTest::isBinary))
        .as("binaries in the repository")
        .isEmpty();
  }

  @Test
  void knowsABinaryByNameOrByItsFirstBytes() throws IOException {
    Path disguised = elsewhere.resolve("harmless.txt");
    Files.write(disguised, HexFormat.of().parseHex("cafebabe00000041"));
    assertThat(isBinary(disguised)).isTrue();
    assertThat(isBinary(Files.createFile(elsewhere.resolve("lib.jar")))).isTrue();
    assertThat(isBinary(Files.writeString(elsewhere.resolve("note.txt"), "text"))).isFalse();
  }

  @Test
  void everyPackageSaysWhatItIsFor() {
    List<Path> packages = Repository.mainPackages(Repository.root());
    assertThat(packages).isNotEmpty();
    assertThat(
            packages.stream()
                .filter(directory -> !Files.exists(directory.resolve("package-info.java"))))
        .as("packages without package-info.java")
        .isEmpty();
  }

  /** A larger package is split. */
  @Test
  void noPackageHasMoreThanFortyFiles() throws IOException {
    List<Path> tests = Repository.testPackages(Repository.root());
    assertThat(tests).anyMatch(directory -> directory.endsWith("org/dfra/build"));
    for (Path directory :
        Stream.concat(Repository.mainPackages(Repository.root()).stream(), tests.stream())
            .toList()) {
      try (Stream<Path> files = Files.list(directory)) {
        assertThat(files.filter(file -> file.toString().endsWith(".java")))
            .as("files of %s", directory)
            .hasSizeLessThanOrEqualTo(41); // with package-info.java
      }
    }
  }

  /** A test that is not run every day is named with the reason, and with what is tested instead. */
  @Test
  void hintsAskForTheNameOfTheCommand() throws IOException {
    List<String> written = new ArrayList<>();
    for (Path folder : Repository.modulesWith(Repository.root(), "src/main/java")) {
      try (Stream<Path> sources = Files.walk(folder.resolve("src/main/java"))) {
        for (Path source : sources.filter(file -> file.toString().endsWith(".java")).toList()) {
          String code = COMMENT.matcher(Files.readString(source)).replaceAll("");
          if (COMMAND_IN_CHECKOUT.matcher(code).find()) {
            written.add(source.getFileName().toString());
          }
        }
      }
    }
    assertThat(written)
        .as("where the command is installed, its name is not ./dfra: use CommandName")
        .containsExactly("CommandName.java");
  }

  @Test
  void theDecisionNamesEachTestWithoutAShortForm() throws IOException, InterruptedException {
    Path root = Repository.root();
    assumeTrue(Files.exists(root.resolve(".git")), "this is no git checkout");
    String only = "@EnabledIfSystemProperty(named = \"dfra.full\"";
    List<String> tests = new ArrayList<>();
    for (Path file : gitFiles(root)) {
      String name = file.getFileName().toString();
      if (name.matches(".*(Test|IT)\\.java")
          && !name.equals("RepositoryTest.java")
          && Files.readString(file).contains(only)) {
        tests.add("`" + name.replace(".java", "") + "`");
      }
    }
    assertThat(tests).contains("`DemoFoundationIT`");
    assertThat(Files.readString(root.resolve("docs/decisions/028-three-tiers-of-tests.md")))
        .contains(tests);
  }

  private static boolean isBinary(Path file) {
    if (BINARY_NAME.matcher(file.getFileName().toString()).matches()) {
      return true;
    }
    try (InputStream in = Files.newInputStream(file)) {
      String beginning = HexFormat.of().formatHex(in.readNBytes(4));
      return BINARY_BEGINNINGS.stream().anyMatch(beginning::startsWith);
    } catch (IOException e) {
      throw new IllegalStateException("cannot read " + file, e);
    }
  }

  private static List<Path> gitFiles(Path root) throws IOException, InterruptedException {
    // safe.directory: a checkout owned by another user (containers do that) is listed all the same.
    Process git;
    try {
      git =
          new ProcessBuilder("git", "-c", "safe.directory=*", "ls-files", "-z")
              .directory(root.toFile())
              .redirectError(ProcessBuilder.Redirect.INHERIT)
              .start();
    } catch (IOException e) {
      return abort("git is not installed here, so no list of what the repository holds");
    }
    String names = new String(git.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(git.waitFor()).as("exit code of git ls-files").isZero();
    return Arrays.stream(names.split("\0"))
        .map(root::resolve)
        .filter(Files::isRegularFile) // deleted, not yet committed
        .toList();
  }
}
