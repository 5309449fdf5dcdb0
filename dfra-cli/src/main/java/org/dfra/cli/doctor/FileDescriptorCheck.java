package org.dfra.cli.doctor;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.cli.doctor.CheckRunner.Check;

/** Checks the limit of open files and sockets of a process, from Linux's /proc/self/limits. */
final class FileDescriptorCheck implements Check {

  /** A group with a registrar, a class server and a listener for each module needs hundreds. */
  private static final long ENOUGH = 4096;

  private static final Pattern LIMIT =
      Pattern.compile("^Max open files +(\\d+)", Pattern.MULTILINE);

  private final Path limits;

  /**
   * @param limits the file with a process's limits; if it does not exist, there are no findings
   */
  FileDescriptorCheck(Path limits) {
    this.limits = limits;
  }

  /** The limit of this process, which its child processes inherit. */
  static FileDescriptorCheck ofThisProcess() {
    return new FileDescriptorCheck(Path.of("/proc/self/limits"));
  }

  @Override
  public Subject subject() {
    return Subject.FILE_DESCRIPTORS;
  }

  @Override
  public List<Finding> run() {
    OptionalLong most = most();
    if (most.isEmpty()) {
      return List.of();
    }
    String what = "a process may have " + most.getAsLong() + " files and sockets open";
    return List.of(
        most.getAsLong() >= ENOUGH
            ? Finding.ok(subject(), what)
            : Finding.warn(
                subject(),
                what,
                "Raise the limit to "
                    + ENOUGH
                    + ": ulimit -n "
                    + ENOUGH
                    + ", or LimitNOFILE in the systemd unit."));
  }

  private OptionalLong most() {
    try {
      Matcher limit = LIMIT.matcher(Files.readString(limits));
      return limit.find() ? OptionalLong.of(Long.parseLong(limit.group(1))) : OptionalLong.empty();
    } catch (IOException e) {
      return OptionalLong.empty(); // not Linux
    }
  }
}
