package org.dfra.cli.doctor;

import java.util.Locale;

/** The subject of a finding. docs/troubleshooting.md has a section for each, by its {@link #id}. */
public enum Subject {
  /** The Java that runs DFRA. */
  JAVA,
  /** {@code java.rmi.activation} on the boot class path. */
  BOOT_JAR,
  /** The archive of classes from which robots' processes start. */
  CLASS_ARCHIVE,
  /** The limit of a process's open files and sockets. */
  FILE_DESCRIPTORS,
  /** The address that this computer's own name resolves to. */
  HOST_NAME,
  /** The address that proxies contain. */
  HOST_ADDRESS,
  /** Whether multicast discovery by group works. */
  MULTICAST,
  /** A port that a robot needs. */
  PORT,
  /** Phoenix's state folder. */
  STATE_FOLDER,
  /** The free space in it. */
  DISK_SPACE,
  /** Phoenix's journal. */
  JOURNAL,
  /** Phoenix itself. */
  PHOENIX,
  /** A service group of a robot on this host. */
  GROUP,
  /** A lookup service. */
  REGISTRAR,
  /** A robot name that is not unique in the team. */
  ROBOT_NAME,
  /** The offset between a robot's clock and this computer's. */
  CLOCK,
  /** A module that cannot be used now, or from this host. */
  MODULE,
  /** An effector in emergency stop. */
  EMERGENCY_STOP,
  /** A robot that can be reached from the network. */
  EXPOSURE,
  /** Who this computer is in its team. */
  IDENTITY;

  /** Its name in text and JSON output, for example {@code boot-jar}. It never changes. */
  public String id() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
