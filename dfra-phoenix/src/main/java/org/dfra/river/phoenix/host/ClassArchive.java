package org.dfra.river.phoenix.host;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.zip.CRC32C;
import java.util.zip.Checksum;
import org.dfra.core.host.PrivateFiles;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The archive of classes from which the processes of a robot start: phoenix and its groups. The
 * Java virtual machine maps it into memory instead of reading and verifying the classes. It is a
 * dynamic archive of class-data sharing, or from JDK 25 on an AOT cache.
 *
 * <p>Its name contains a checksum of the Java runtime and of the name, size and time of each jar,
 * so an archive of other jars is not found. The virtual machine checks this too, and starts without
 * an archive that does not fit. It does not print anything then. But it crashes if an archive is
 * incomplete or damaged. So a file beside it, the seal, has its size and a checksum of its content,
 * and an archive that does not match it is not used.
 *
 * <p>An archive is code. It is used only in a folder that belongs to this user and that no other
 * user may enter.
 */
public final class ClassArchive {

  /** System property with the path of the commands' archive. The robots' is in the same folder. */
  public static final String COMMANDS = "dfra.command-archive";

  private static final Logger LOG = LoggerFactory.getLogger(ClassArchive.class);

  /** Names of robots' archives for this version of Java begin with this. */
  public static final String ROBOT = "robot-" + Runtime.version().feature() + "-";

  private static final String BOOT = "-Xbootclasspath/a:";
  private static final List<String> CLASS_PATH = List.of("-cp", "-classpath", "--class-path");

  /** Options that say themselves whether and from which archive a process starts. */
  private static final List<String> OWN_ARCHIVE =
      List.of("-Xshare", "-XX:SharedArchiveFile", "-XX:ArchiveClassesAtExit", "-XX:AOT");

  /** The first Java whose archives are AOT caches. */
  private static final int AOT = 25;

  /** The last Java that is known to have the option that places archives. */
  private static final int LAST_TESTED = 25;

  /** Exit codes of a crash: SIGABRT, by which a virtual machine ends, SIGBUS and SIGSEGV. */
  private static final Set<Integer> CRASHES = Set.of(134, 135, 139);

  static volatile boolean distrusted; // a test resets it

  /** Path, identity, size and time of the archive that was read last and is whole. */
  private static volatile String knownWhole = "";

  private final Path file;

  private ClassArchive(Path file) {
    this.file = file;
  }

  /**
   * The archive for a process that this Java starts, whether it exists or not. Empty if the command
   * that started this process named no folder for archives, the options name an archive themselves,
   * or the class path has something other than jars.
   *
   * @param options those of the process, with its boot class path and its class path
   */
  public static Optional<ClassArchive> of(List<String> options) {
    @Nullable String commands = System.getProperty(COMMANDS);
    if (commands == null || commands.isBlank() || namesItsOwn(options)) {
      return Optional.empty();
    }
    try {
      Path other = Path.of(commands).toAbsolutePath();
      return checksum(options)
          .map(sum -> new ClassArchive(other.resolveSibling(ROBOT + sum + suffix())));
    } catch (IOException | InvalidPathException e) {
      LOG.debug("There is no archive of classes for {}.", options, e);
      return Optional.empty();
    }
  }

  private static boolean namesItsOwn(List<String> options) {
    return options.stream().anyMatch(each -> OWN_ARCHIVE.stream().anyMatch(each::startsWith));
  }

  private static String suffix() {
    return isAotCache() ? ".aot" : ".jsa";
  }

  private static boolean isAotCache() {
    return Runtime.version().feature() >= AOT;
  }

  /** Of the Java runtime and of all jars; empty if a part of the class path is no jar. */
  private static Optional<String> checksum(List<String> options) throws IOException {
    Checksum sum = new CRC32C();
    for (String property : List.of("java.home", "java.vm.name", "java.vm.version")) {
      add(sum, System.getProperty(property));
    }
    boolean hasClassPath = false;
    for (int i = 0; i < options.size(); i++) {
      String option = options.get(i);
      boolean isClassPath = CLASS_PATH.contains(option) && i + 1 < options.size();
      if (isClassPath || option.startsWith(BOOT)) {
        String path = isClassPath ? options.get(++i) : option.substring(BOOT.length());
        add(sum, isClassPath ? "class path" : "boot class path");
        hasClassPath |= isClassPath;
        for (String entry : path.split(File.pathSeparator, -1)) {
          if (!addJar(sum, entry)) {
            return Optional.empty();
          }
        }
      }
    }
    return hasClassPath ? Optional.of(String.format("%08x", sum.getValue())) : Optional.empty();
  }

  /** False if the entry is something other than a file. */
  private static boolean addJar(Checksum sum, String entry) throws IOException {
    add(sum, entry);
    try {
      BasicFileAttributes jar = Files.readAttributes(Path.of(entry), BasicFileAttributes.class);
      add(sum, jar.size() + " " + jar.lastModifiedTime().toMillis());
      return jar.isRegularFile();
    } catch (NoSuchFileException e) {
      return true; // the virtual machine ignores it too
    }
  }

  private static void add(Checksum sum, String text) {
    sum.update((text + "\n").getBytes(StandardCharsets.UTF_8));
  }

  /** The file, which may not exist. */
  public Path file() {
    return file;
  }

  private Path folder() {
    return Objects.requireNonNull(file.getParent());
  }

  /** Whether it can be used: it is whole, and no other user can have written it. */
  public boolean isUsable() {
    try {
      return !distrusted
          && Files.isRegularFile(file)
          && PrivateFiles.privacyFault(folder()) == null
          && isWhole();
    } catch (IOException e) {
      LOG.debug("{} is not used.", file, e);
      return false;
    }
  }

  /** Reads the archive only once, unless it changes: that takes some milliseconds. */
  private boolean isWhole() throws IOException {
    BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
    String version =
        file + " " + now.fileKey() + " " + now.size() + " " + now.lastModifiedTime().toMillis();
    if (!version.equals(knownWhole)) {
      if (!Files.readString(seal(file)).equals(sealOf(file))) {
        return false;
      }
      knownWhole = version;
    }
    return true;
  }

  private static Path seal(Path archive) {
    return archive.resolveSibling(archive.getFileName() + ".seal");
  }

  private static String sealOf(Path archive) throws IOException {
    CRC32C sum = new CRC32C();
    long size = 0;
    byte[] part = new byte[1 << 16];
    try (InputStream in = Files.newInputStream(archive)) {
      for (int n = in.read(part); n > 0; n = in.read(part)) {
        sum.update(part, 0, n);
        size += n;
      }
    }
    return String.format("%d bytes, CRC-32C %08x%n", size, sum.getValue());
  }

  /**
   * Makes a draft the archive, in one step, and its content durable.
   *
   * @param draft a complete archive in the same folder
   * @throws IOException if it cannot be read or renamed, or the seal cannot be written
   */
  public void publish(Path draft) throws IOException {
    try (FileChannel content = FileChannel.open(draft)) {
      content.force(true);
    }
    Path seal = seal(draft);
    Files.writeString(seal, sealOf(draft), StandardOpenOption.CREATE, StandardOpenOption.SYNC);
    Files.move(seal, seal(file), StandardCopyOption.ATOMIC_MOVE);
    Files.move(draft, file, StandardCopyOption.ATOMIC_MOVE);
  }

  /**
   * Records how a process that may have started from an archive ended. If its virtual machine
   * crashed, no further process is started from one while this process runs: the archive may be the
   * reason.
   *
   * @param exitCode 128 and the signal's number if a signal ended the process
   */
  public static void recordExit(int exitCode) {
    if (CRASHES.contains(exitCode) && !distrusted) {
      distrusted = true;
      LOG.warn(
          "A virtual machine crashed (exit code {}). Until phoenix is started again, groups start"
              + " without the archive of classes, which may be the reason.",
          exitCode);
    }
  }

  /**
   * The options that let a process start fast and share its memory with the others. They fit only
   * this Java, so they are not to be stored.
   *
   * @param options those that the process has already
   */
  public static List<String> startOptions(List<String> options) {
    List<String> added = new ArrayList<>(placementOptions());
    of(options).filter(ClassArchive::isUsable).ifPresent(each -> added.addAll(each.useOptions()));
    return added;
  }

  /**
   * Archives, also the JDK's own, are mapped at the address for which they were written. At another
   * address, each process would change most pages, and so have its own copy of them.
   */
  private static List<String> placementOptions() {
    return Runtime.version().feature() <= LAST_TESTED
        ? List.of("-XX:+UnlockDiagnosticVMOptions", "-XX:ArchiveRelocationMode=0")
        : List.of();
  }

  private List<String> useOptions() {
    return isAotCache()
        ? List.of("-XX:AOTCache=" + file, "-Xlog:aot*=off", "-Xlog:cds*=off")
        : List.of("-XX:SharedArchiveFile=" + file, "-Xlog:cds*=off");
  }

  /**
   * The options with which a process writes an archive at its end.
   *
   * @param draft the file, which must not exist
   */
  public static List<String> writeOptions(Path draft) {
    return isAotCache()
        ? List.of("-XX:AOTCacheOutput=" + draft, "-Xlog:aot*=off", "-Xlog:cds*=off")
        : List.of("-XX:ArchiveClassesAtExit=" + draft, "-Xlog:cds*=off");
  }
}
