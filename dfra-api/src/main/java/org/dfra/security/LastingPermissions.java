package org.dfra.security;

/** Nothing that was permitted is taken back. */
final class LastingPermissions implements Permissions {

  @Override
  public long version() {
    return 0;
  }

  @Override
  public boolean isStillPermitted(AccessRequest call) {
    return true;
  }

  @Override
  public Runnable onReplacement(Runnable listener) {
    return () -> {};
  }
}
