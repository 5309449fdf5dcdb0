package org.dfra.cli.doctor;

import java.util.List;
import java.util.Optional;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.dfra.core.host.CommandName;
import org.dfra.river.bootstrap.JvmCommand;
import org.dfra.river.phoenix.host.ClassArchive;

/** Reports whether a robot's processes start from an archive of classes. They work without one. */
final class ArchiveCheck implements Check {

  private final Optional<ClassArchive> archive;

  /**
   * @param archive that of these jars, whether it exists or not; empty if none is kept
   */
  ArchiveCheck(Optional<ClassArchive> archive) {
    this.archive = archive;
  }

  /** The check for the jars of this process. */
  static ArchiveCheck ofThisProcess() {
    return new ArchiveCheck(JvmCommand.archive());
  }

  @Override
  public Subject subject() {
    return Subject.CLASS_ARCHIVE;
  }

  @Override
  public List<Finding> run() {
    return archive
        .map(
            each ->
                each.isUsable()
                    ? "robots' processes start from the archive " + each.file()
                    : "there is no archive of classes yet, so processes start more slowly; "
                        + CommandName.current()
                        + " up writes "
                        + each.file())
        .map(what -> List.of(Finding.ok(subject(), what)))
        .orElse(List.of());
  }
}
