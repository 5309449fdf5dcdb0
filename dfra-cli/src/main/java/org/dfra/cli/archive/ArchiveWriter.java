package org.dfra.cli.archive;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.dfra.cli.Main;
import org.dfra.core.host.PrivateFiles;
import org.dfra.river.bootstrap.JvmCommand;
import org.dfra.river.phoenix.host.ClassArchive;

/**
 * The program that writes the missing archives of classes: one for commands, one for the processes
 * of robots. {@code ./dfra build} runs it, and {@code dfra up} starts it in the background when the
 * robot is up.
 *
 * <p>An archive appears in one step, complete and tried out: another process has started from it.
 * If anything fails, everything starts without that archive, as before. Nothing is printed.
 */
final class ArchiveWriter {

  /** An archive takes some seconds on an idle computer; a process that hangs is ended. */
  private static final long TIME_LIMIT_SECONDS = 180;

  private static final String LIB = "dfra.lib";
  private static final String DRAFT = "draft-";

  private final Path commands;
  private final Path folder;

  private ArchiveWriter(Path commands) {
    this.commands = commands;
    this.folder = Objects.requireNonNull(commands.getParent());
  }

  /** Writes what is missing; needs no arguments. */
  public static void main(String[] args) throws IOException, InterruptedException {
    String commands = System.getProperty(ClassArchive.COMMANDS, "");
    if (!commands.isBlank()) {
      Optional<ClassArchive> robots = JvmCommand.archive();
      System.clearProperty(ClassArchive.COMMANDS); // what is started here is to use no archive
      new ArchiveWriter(Path.of(commands).toAbsolutePath()).write(robots);
    }
  }

  private static Process start(List<String> command) throws IOException {
    return new ProcessBuilder(command)
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .redirectError(ProcessBuilder.Redirect.DISCARD)
        .start();
  }

  private void write(Optional<ClassArchive> robots) throws IOException, InterruptedException {
    PrivateFiles.makeFolder(folder);
    if (PrivateFiles.privacyFault(folder) != null) {
      return; // others could put an archive there
    }
    try (FileChannel file =
            FileChannel.open(
                folder.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        FileLock lock = file.tryLock()) {
      if (lock != null) { // else another one writes them
        removeAll(DRAFT + "*");
        if (robots.isPresent() && !robots.get().isUsable() && !hasFailed(robots.get().file())) {
          noteFailure(robots.get().file(), !writeRobots(robots.get()));
        }
        if ((!Files.exists(commands) || isOlderThanJars(commands)) && !hasFailed(commands)) {
          noteFailure(commands, !writeCommands());
        }
      }
    }
  }

  /** Whether it could not be written from these jars: to try again would fail again. */
  private boolean hasFailed(Path archive) throws IOException {
    Path note = failureNote(archive);
    return Files.exists(note) && !isOlderThanJars(note);
  }

  private void noteFailure(Path archive, boolean failed) throws IOException {
    Path note = failureNote(archive);
    Files.deleteIfExists(note);
    if (failed) {
      Files.createFile(note);
    }
  }

  private Path failureNote(Path archive) {
    return folder.resolve("failed-" + archive.getFileName());
  }

  /** As the launcher judges it. */
  private static boolean isOlderThanJars(Path archive) throws IOException {
    Path jars = Path.of(System.getProperty(LIB, ""));
    return Files.getLastModifiedTime(archive).compareTo(Files.getLastModifiedTime(jars)) < 0;
  }

  private void removeAll(String pattern) throws IOException {
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, pattern)) {
      for (Path each : files) {
        Files.deleteIfExists(each);
      }
    }
  }

  /** Returns whether it was written. */
  private boolean writeRobots(ClassArchive archive) throws IOException, InterruptedException {
    Path draft = folder.resolve(DRAFT + archive.file().getFileName());
    try {
      boolean isWritten =
          isWritten(draft, List.of(ArchivedProcesses.class.getName(), draft.toString()));
      if (isWritten) {
        removeAll(ClassArchive.ROBOT + "*"); // of other jars
        archive.publish(draft);
      }
      return isWritten;
    } finally {
      removeAll(DRAFT + "*");
    }
  }

  /** Returns whether it was written. */
  private boolean writeCommands() throws IOException, InterruptedException {
    Path draft = folder.resolve(DRAFT + commands.getFileName());
    try {
      boolean isWritten =
          isWritten(
              draft, List.of("-XX:ArchiveClassesAtExit=" + draft, ArchivedClasses.class.getName()));
      if (isWritten) {
        try (FileChannel content = FileChannel.open(draft)) {
          content.force(true);
        }
        Files.move(draft, commands, StandardCopyOption.ATOMIC_MOVE);
      }
      return isWritten;
    } finally {
      removeAll(DRAFT + "*");
    }
  }

  private static boolean isWritten(Path draft, List<String> arguments)
      throws IOException, InterruptedException {
    return isRunWell(arguments) && Files.isRegularFile(draft) && isRunWell(arguments(draft));
  }

  /** Of a process that ends well only if it can start from this archive. */
  private static List<String> arguments(Path draft) {
    List<String> arguments =
        new ArrayList<>(
            draft.toString().endsWith(".aot")
                ? List.of("-XX:AOTCache=" + draft, "-XX:AOTMode=on")
                : List.of("-XX:SharedArchiveFile=" + draft, "-Xshare:on"));
    arguments.addAll(List.of(Main.class.getName(), "--version"));
    return arguments;
  }

  private static boolean isRunWell(List<String> arguments)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(JvmCommand.java()));
    command.addAll(JvmCommand.options());
    command.addAll(arguments);
    Process process = start(command);
    process.getOutputStream().close();
    if (process.waitFor(TIME_LIMIT_SECONDS, TimeUnit.SECONDS)) {
      return process.exitValue() == 0;
    }
    process.descendants().forEach(ProcessHandle::destroyForcibly);
    process.destroyForcibly();
    return false;
  }
}
