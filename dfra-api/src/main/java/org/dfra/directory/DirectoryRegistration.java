package org.dfra.directory;

/** A registration with a directory, valid until it is closed. */
public interface DirectoryRegistration extends AutoCloseable {

  /** Ends it. A call in progress may still finish. */
  @Override
  void close();
}
