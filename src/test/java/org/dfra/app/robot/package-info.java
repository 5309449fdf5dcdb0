/** Bringing robots up among others. */
package org.dfra.app.robot;
