package org.dfra.app.doctor;

import java.util.Locale;

/** What a finding is about. docs/troubleshooting.md has a section for each, by its {@link #id}. */
public enum Subject {
  /** The Java that runs DFRA. */
  JAVA,
  /** {@code java.rmi.activation} on the boot class path. */
  BOOT_JAR,
  /** How many files and sockets a process may have open. */
  FILE_DESCRIPTORS,
  /** What this computer's own name stands for. */
  HOST_NAME,
  /** The address that proxies carry. */
  HOST_ADDRESS,
  /** Whether lookup services can be found by group. */
  MULTICAST,
  /** A port that a robot needs. */
  PORT,
  /** The folder of what phoenix keeps. */
  STATE_FOLDER,
  /** The room that is left there. */
  DISK_SPACE,
  /** Phoenix's journal. */
  JOURNAL,
  /** Phoenix itself. */
  PHOENIX,
  /** A service group of a robot on this host. */
  GROUP,
  /** A lookup service. */
  REGISTRAR,
  /** A name that more than one robot of the team has. */
  ROBOT_NAME,
  /** How far a robot's clock is off this computer's. */
  CLOCK,
  /** A module that cannot be used now, or here. */
  MODULE,
  /** An effector that is stopped for an emergency. */
  EMERGENCY_STOP,
  /** A robot that others can reach. */
  EXPOSURE;

  /** Its name for people and programs, {@code boot-jar} say. It never changes. */
  public String id() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
