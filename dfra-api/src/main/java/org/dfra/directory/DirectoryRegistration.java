package org.dfra.directory;

/** Something that goes on until it is closed. */
public interface DirectoryRegistration extends AutoCloseable {

  /** Ends it. A call that is under way may still finish. */
  @Override
  void close();
}
